// A case with what keys can be: names with blanks and dots, inline and dotted tables.
#pragma once

namespace moraine {

inline constexpr char const* sample_case = R"(title = "sample"
space.dimension = 2
resolution = { spacing = "1 cm", smoothing_factor = 1.5 }
[time]
end = "1 ms"
[output]
arrival_pressure = "1 MPa"
[material.water]         # first in the file, last in the alphabet
eos = "tait"
reference_sound_speed = 100.0
[material.gas]
eos = "ideal_gas"
heat_capacity_ratio = 1.4
reference_density = 1.2
reference_energy = "0.2 MJ/kg"
[[region]]
name = "sea"
material = "water"
box = { min = [0.0, 0.0], max = [0.5, 0.5] }
[[region]]
name = "bubble"
material = "gas"
disc = { center = [0.25, 0.25], radius = "5 cm" }
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [0.5, 0.5] }
[[gauge]]
name = "1.5 cm"
position = [0.015, 0.25]
[[gauge]]
name = "1"
position = [0.4, 0.25]
[[gauge]]
name = "top"
kind = "front"
material = "gas"
axis = "y+"
)";

}  // namespace moraine
