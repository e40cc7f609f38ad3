// Where the record of a point lies, and where the records that lie nowhere are.
//
// Neighbour lists hold 16-bit offsets, which halves the memory of a run. A group of lanes that is
// not full is padded with a record far from everything; for such a record to be in reach of any
// offset, one is put behind every 32768 records.
#pragma once

#include <cstddef>
#include <cstdint>

namespace moraine {

inline constexpr std::uint32_t slot_page = 32768;

/// Slot of the record of point i: whole pages of records are followed by one that lies nowhere.
constexpr std::uint32_t slot_of(std::uint32_t i) { return i + i / slot_page; }

/// Slot of the record that lies nowhere and closes the page of this slot.
constexpr std::uint32_t nowhere_after(std::uint32_t slot) {
  return (slot / (slot_page + 1)) * (slot_page + 1) + slot_page;
}

constexpr bool is_nowhere(std::uint32_t slot) { return slot % (slot_page + 1) == slot_page; }

/// Point whose record is in this slot, which is not one that lies nowhere.
constexpr std::uint32_t point_at(std::uint32_t slot) { return slot - slot / (slot_page + 1); }

/// Slots for `points` records, with the one that closes the last page.
constexpr std::size_t slots_for(std::size_t points) {
  std::size_t const pages = points / slot_page + 1;
  return pages * (slot_page + 1);
}

}  // namespace moraine
