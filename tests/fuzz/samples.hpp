// Small inputs of each kind, to start mutations from.
#pragma once

#include <string>

namespace moraine::fuzzing {

/// A tetrahedron as STL text.
inline std::string stl_text() {
  std::string const corners[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  int const faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string text = "solid tetrahedron\n";
  for (auto const& face : faces) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (int const corner : face) text += "  vertex " + corners[corner] + "\n";
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

/// Regions of every shape, layers, stages and gauges, in few particles.
inline std::string rich_case() {
  return R"(title = "every shape"
space = { dimension = 3, domain = { min = [-1, -1, -1], max = [2, 2, 2] } }
physics.gravity = [0.0, 0.0, "-1 g0"]
resolution = { spacing = "20 cm", smoothing_factor = 1.3, lattice = "hexagonal" }
time = { end = "1 ms" }
output = { frames = 0.005, gauges = 0.002, arrival_pressure = "1 kPa" }
material.water = { eos = "tait", reference_sound_speed = 20.0 }
material.air = { use = "air" }
material.tnt = { use = "tnt" }
[[region]]
name = "body"
material = "water"
stl = { file = "body.stl", units = "m", shift = [0.1, 0.1, 0.1] }
plus = [{ disc = { center = [0, 0, 0], radius = 0.5 } }]
minus = [{ cylinder = { start = [0, 0, -1], end = [0, 0, 1], radius = 0.1 } }]
[[region]]
name = "slope"
polygon = { corners = [[0, 0], [1, 0], [0, 1]], axis = "y", from = -0.5, to = 0.5 }
layers = { materials = ["water", "air"], thickness = [0.3] }
lithostatic_load = "1 atm"
[[region]]
name = "charge"
material = "tnt"
box = { min = [1, 1, 1], max = [1.5, 1.5, 1.5] }
[[region]]
name = "half"
material = "air"
half_plane = { point = [0, 0, -0.8], normal = [0, 0, 1] }
minus = [{ box = { min = [-1, -1, -1], max = [0, 2, 2] } }]
[[wall]]
name = "tank"
container = { min = [-1, -1, -1], max = [2, 2, 2] }
open = ["z+"]
slip = "none"
[[gauge]]
name = "p"
position = [0, 0, 0]
[[gauge]]
name = "level"
kind = "level"
position = [0, 0, 0]
[[gauge]]
name = "hole"
kind = "crater"
materials = ["water"]
crater = { level = 0.5, center = [0, 0, 0], radius = 0.8, sectors = 6 }
[[gauge]]
name = "heat"
kind = "expression"
formula = "density > 0 ? specific_energy * mass : -1"
reduce = "sum"
unit = "J"
within = { min = [-1, -1, -1], max = [1, 1, 1] }
[[gauge]]
name = "cut"
kind = "plane"
plane = { min = [-1, 0, -1], max = [1, 0, 1], step = 0.5 }
[[stage]]
name = "rest"
damping_time = "1 ms"
until = { after = "1 ms" }
[[stage]]
name = "bang"
detonate = "charge"
into = "air"
)";
}

/// A table as a run writes it.
inline std::string table_text() {
  return "time [s],\"foot, left pressure [Pa]\",tip x [m]\n0,0,0.2\n0.002,1.5e3,0.25\n"
         "0.004,nan,-inf\n";
}

/// The energies and sums that the picture of sums needs.
inline std::string sums_text() {
  return "time [s],kinetic_energy [J],internal_energy [J],potential_energy [J],total_energy [J],"
         "momentum_x [kg m/s],momentum_y [kg m/s],momentum_z [kg m/s],time_step [s]\n"
         "0,0,1,2,3,0,0,0,1e-5\n0.1,0.5,1,1.5,3,0.1,0.2,0,1e-5\n";
}

/// A frame of three particles: points, a vector, scalars; raw appended.
inline std::string frame_bytes(int dimension) {
  std::string text = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>
<FieldData>
<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">0.5</DataArray>
<DataArray type="Int32" Name="dimension" NumberOfTuples="1" format="ascii">)" +
                     std::to_string(dimension) + R"(</DataArray>
</FieldData>
<Piece NumberOfPoints="3" NumberOfVerts="0">
<PointData>
<DataArray type="Float32" Name="mass" NumberOfComponents="1" format="appended" offset="44"/>
<DataArray type="Float32" Name="density" NumberOfComponents="1" format="appended" offset="44"/>
<DataArray type="Float32" Name="pressure" NumberOfComponents="1" format="appended" offset="44"/>
<DataArray type="Float32" Name="velocity" NumberOfComponents="3" format="appended" offset="0"/>
</PointData>
<Points>
<DataArray type="Float32" Name="position" NumberOfComponents="3" format="appended" offset="0"/>
</Points>
</Piece>
</PolyData>
<AppendedData encoding="raw">
_)";
  auto const add = [&text](auto value) {
    text.append(reinterpret_cast<char const*>(&value), sizeof value);
  };
  add(36UL);
  for (int i = 0; i < 9; ++i) add(0.1F * static_cast<float>(i));
  add(12UL);
  for (int i = 0; i < 3; ++i) add(1.0F + static_cast<float>(i));
  return text + "\n</AppendedData>\n</VTKFile>\n";
}

/// The list of frames of a run.
inline std::string collection_text() {
  return R"(<?xml version="1.0"?>
<VTKFile type="Collection" version="1.0" byte_order="LittleEndian">
<Collection><DataSet timestep="0.5" part="0" file="frames/particles_000000.vtp"/></Collection>
</VTKFile>
)";
}

/// A manifest as the program reads it back.
inline std::string manifest_text() {
  return R"({"program": "moraine", "state": "ended", "end": {"reason": "end time reached"}})";
}

}  // namespace moraine::fuzzing
