#include "report/page.hpp"

#include <fmt/core.h>

#include <stdexcept>
#include <string_view>

#include "output/manifest.hpp"
#include "report/assets.hpp"
#include "report/html_text.hpp"

namespace moraine::report {
namespace {

std::string_view asset(std::string_view name) {
  for (EmbeddedText const& text : report_assets())
    if (text.name == name) return text.text;
  throw std::logic_error(fmt::format("the program has no asset '{}'", name));
}

/// JSON in which no "</script>" can stand.
std::string script_safe(Json const& json) {
  std::string const text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (char const c : text) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

Json citation() {
  BuildInfo const build = build_info();
  constexpr char const* title =
      "Moraine: a particle solver for explosions, landslides, tanks and ice";
  return {{"text", fmt::format("The Moraine authors. {}. Version {}, revision {}. Apache-2.0.",
                               title, build.version, build.git_revision)},
          {"bibtex",
           fmt::format("@software{{moraine,\n  author = {{{{The Moraine authors}}}},\n  "
                       "title = {{{{{}}}}},\n  version = {{{}}},\n  note = {{revision {}}}\n}}",
                       title, build.version, build.git_revision)}};
}

}  // namespace

Json empty_report() {
  BuildInfo const build = build_info();
  return {{"format", 1},
          {"program",
           {{"name", "Moraine"}, {"version", build.version}, {"revision", build.git_revision}}},
          {"made", utc_now()},
          {"cite", citation()},
          {"live", nullptr},
          {"runs", Json::array()},
          {"sweep", nullptr}};
}

std::string page_of(std::string const& title, Json const& report, Blocks const& blocks,
                    bool with_player) {
  std::string const data = "<script type=\"application/json\" id=\"report\">" +
                           script_safe(report) + "</script>\n" + blocks.elements();
  std::string const player =
      with_player ? fmt::format("<script>{}</script>", asset("player")) : std::string();
  // Cut at the marks first: data may hold texts that look like marks.
  std::string_view rest = asset("page");
  std::string page;
  page.reserve(rest.size() + data.size() + player.size() + title.size());
  while (!rest.empty()) {
    std::size_t const at = rest.find("@@");
    page += rest.substr(0, at);
    if (at == std::string_view::npos) break;
    rest.remove_prefix(at);
    std::size_t const end = rest.find("@@", 2);
    std::string_view const mark = rest.substr(0, end == std::string_view::npos ? end : end + 2);
    if (mark == "@@TITLE@@")
      page += html_escaped(title);
    else if (mark == "@@DATA@@")
      page += data;
    else if (mark == "@@PLAYER@@")
      page += player;
    else {  // no mark after all
      page += rest.substr(0, 2);
      rest.remove_prefix(2);
      continue;
    }
    rest.remove_prefix(mark.size());
  }
  return page;
}

std::size_t bytes_in_page(Json const& json) { return script_safe(json).size(); }

std::size_t page_size(bool with_player) {
  return asset("page").size() + (with_player ? asset("player").size() : 0);
}

}  // namespace moraine::report
