#include "output/pvd_collection.hpp"

#include <fmt/core.h>

#include <pugixml.hpp>
#include <stdexcept>
#include <utility>

#include "output/atomic_file.hpp"

namespace moraine {

PvdCollection::PvdCollection(std::filesystem::path path, std::vector<PvdEntry> entries)
    : path_(std::move(path)), entries_(std::move(entries)) {}

void PvdCollection::add(double time, std::string file) {
  entries_.push_back({time, std::move(file)});
  write();
}

void PvdCollection::write() const {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("VTKFile");
  root.append_attribute("type") = "Collection";
  root.append_attribute("version") = "1.0";
  root.append_attribute("byte_order") = "LittleEndian";
  pugi::xml_node collection = root.append_child("Collection");
  for (PvdEntry const& entry : entries_) {
    pugi::xml_node node = collection.append_child("DataSet");
    node.append_attribute("timestep") = fmt::format("{}", entry.time).c_str();
    node.append_attribute("part") = 0;
    node.append_attribute("file") = entry.file.c_str();
  }
  AtomicFile output(path_);
  document.save(output.stream());
  output.commit();
}

std::vector<PvdEntry> read_pvd(std::filesystem::path const& path) {
  pugi::xml_document document;
  pugi::xml_parse_result const result = document.load_file(path.c_str());
  if (!result)
    throw std::runtime_error(
        fmt::format("cannot read collection '{}': {}", path.string(), result.description()));
  pugi::xml_node const collection = document.child("VTKFile").child("Collection");
  if (!collection)
    throw std::runtime_error(fmt::format("'{}' is not a .pvd collection", path.string()));
  std::vector<PvdEntry> entries;
  for (pugi::xml_node const node : collection.children("DataSet"))
    entries.push_back({node.attribute("timestep").as_double(), node.attribute("file").value()});
  return entries;
}

}  // namespace moraine
