// The page itself: data put into the page that was built from report/.
#pragma once

#include <cstddef>
#include <string>

#include "report/blocks.hpp"

namespace moraine::report {

/// What stands around the runs: program, time, how to cite; no runs, not live.
Json empty_report();

/// The whole HTML file. `title` may hold anything. The player is put in where `with_player`.
std::string page_of(std::string const& title, Json const& report, Blocks const& blocks,
                    bool with_player);

/// Bytes that JSON takes in the page.
std::size_t bytes_in_page(Json const& json);

/// Bytes of the page without data: with and without the player.
std::size_t page_size(bool with_player);

}  // namespace moraine::report
