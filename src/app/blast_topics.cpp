#include "app/blast_topics.hpp"

#include <array>

namespace moraine {
namespace {

using blast::Situation;
using blast::Topic;

constexpr Dimension mass{"a mass", "kg", {"kg", "g", "t", "lb"}};
constexpr Dimension length{"a length", "m", {"m", "cm", "mm", "ft", "in"}};
constexpr Dimension duration{"a time", "s", {"ms", "s", "us"}};
constexpr Dimension pressure{"a pressure", "Pa", {"kPa", "Pa", "MPa", "bar", "psi", "atm"}};
constexpr Dimension density{"a density", "kg/m^3", {"kg/m^3", "g/cm^3"}};
constexpr Dimension angle{"an angle", "rad", {"deg", "rad"}};
constexpr Dimension energy{"an energy", "J", {"MJ", "J", "kJ"}};
constexpr Dimension number{"a plain number", "1", {"1"}};

template <double Situation::*member>
double& input(Situation& s) {
  return s.*member;
}

constexpr Accepts positive = Accepts::positive, not_negative = Accepts::not_negative;

constexpr std::array quantities{
    QuantityOption{"--charge", "mass of the charge", mass, positive,
                   input<&Situation::charge_mass>},
    QuantityOption{"--distance", "distance from the centre or axis of the charge", length, positive,
                   input<&Situation::distance>},
    QuantityOption{"--ambient-pressure", "pressure of the air (101.325 kPa)", pressure, positive,
                   [](Situation& s) -> double& { return s.air.pressure; }},
    QuantityOption{"--ambient-density", "density of the air (1.225 kg/m^3)", density, positive,
                   [](Situation& s) -> double& { return s.air.density; }},
    QuantityOption{"--ground-factor", "charge on the ground over charge in free air (1.8)", number,
                   positive, input<&Situation::ground_factor>},
    QuantityOption{"--pressure", "overpressure of the incident front or peak of the pulse",
                   pressure, positive, input<&Situation::overpressure>},
    QuantityOption{"--angle", "between front and wall, 0 head-on", angle,
                   Accepts::below_right_angle, input<&Situation::angle>},
    QuantityOption{"--duration", "duration of the positive phase", duration, positive,
                   input<&Situation::duration>},
    QuantityOption{"--decay", "decay k of Friedlander's history", number, not_negative,
                   input<&Situation::decay>},
    QuantityOption{"--time", "time since the arrival", duration, not_negative,
                   input<&Situation::time>},
    QuantityOption{"--length", "length of the line charge", length, positive,
                   input<&Situation::length>},
    QuantityOption{"--side-a", "side of the face in contact", length, positive,
                   input<&Situation::side_a>},
    QuantityOption{"--side-b", "other side of the face in contact", length, positive,
                   input<&Situation::side_b>},
    QuantityOption{"--height", "height of the charge above the face", length, positive,
                   input<&Situation::height>},
    QuantityOption{"--depth", "depth of the centre of the charge", length, positive,
                   input<&Situation::depth>},
    QuantityOption{"--coupling", "coupling f of a shallow charge, up to 1", number, Accepts::share,
                   input<&Situation::coupling>},
    QuantityOption{"--depth-factor", "factor f of the depth in Lampson's crater", number, positive,
                   input<&Situation::depth_factor>},
    QuantityOption{"--bubble-energy", "energy of the bubble (from its largest radius)", energy,
                   positive, input<&Situation::bubble_energy>},
    QuantityOption{"--water-density", "density of the water (1000 kg/m^3)", density, positive,
                   [](Situation& s) -> double& { return s.water.density; }},
    QuantityOption{"--surface-pressure", "pressure above the water (101.325 kPa)", pressure,
                   positive, [](Situation& s) -> double& { return s.water.surface_pressure; }},
};

constexpr std::array names{
    NameOption{"--explosive", "explosive (tnt)"},
    NameOption{"--pressure-factor", "its pressures and impulses over those of TNT"},
    NameOption{"--mass-factor", "kg of TNT that 1 kg of it is worth"},
    NameOption{"--soil", "kind of soil"},
    NameOption{"--ground", "kind of ground"},
    NameOption{"--impulse", "impulse of the positive phase, which gives the decay"},
    NameOption{"--gauges", "gauges.json of a run, to set one of its gauges beside"},
    NameOption{"--gauge", "which gauge of the run"},
};

constexpr std::array output_units{
    OutputUnitOption{"--pressure-unit", blast::Kind::pressure},
    OutputUnitOption{"--impulse-unit", blast::Kind::impulse},
    OutputUnitOption{"--time-unit", blast::Kind::time},
    OutputUnitOption{"--length-unit", blast::Kind::length},
    OutputUnitOption{"--speed-unit", blast::Kind::speed},
};

constexpr SweepOption over_distance{"--distances", "--distance", "distance", true};
constexpr SweepOption over_charge{"--charges", "--charge", "charge", true};

constexpr std::array commands{
    TopicCommand{Topic::air, "a spherical charge in free air", "--charge --distance",
                 "--explosive --pressure-factor --mass-factor --ambient-pressure --ambient-density "
                 "--gauges --gauge",
                 over_distance,
                 "moraine blast air --charge \"10 kg\" --distance \"5 m\"\n"
                 "moraine blast air --charge \"10 kg\" --distance \"5 m\" --ambient-pressure "
                 "\"70 kPa\" --ambient-density \"0.91 kg/m^3\"\n"
                 "moraine blast air --charge \"22 lb\" --explosive comp_b --distance \"16 ft\" "
                 "--units imperial\n"
                 "moraine blast air --charge \"10 kg\" --distances \"1 m\" \"50 m\" 40 --csv "
                 "air.csv --plot air.svg"},
    TopicCommand{Topic::surface, "a charge on the ground", "--charge --distance",
                 "--explosive --pressure-factor --mass-factor --ground-factor --ambient-pressure "
                 "--ambient-density --gauges --gauge",
                 over_distance,
                 "moraine blast surface --charge \"100 kg\" --distance \"20 m\"\n"
                 "moraine blast surface --charge \"100 kg\" --distance \"20 m\" --pressure-unit "
                 "psi --json"},
    TopicCommand{
        Topic::reflection,
        "a front that meets a rigid wall",
        "--pressure",
        "--angle --charge --distance --surface-burst --explosive --pressure-factor "
        "--mass-factor --ambient-pressure --ambient-density",
        {"--angles", "--angle", "angle", false},
        "moraine blast reflection --pressure \"200 kPa\"\n"
        "moraine blast reflection --pressure \"200 kPa\" --angle \"35 deg\"\n"
        "moraine blast reflection --charge \"10 kg\" --distance \"4 m\" --angles \"0 deg\" "
        "\"60 deg\" 13"},
    TopicCommand{Topic::pulse,
                 "the history of overpressure at a place",
                 "--pressure --duration",
                 "--decay --impulse --time --charge --distance --surface-burst --explosive "
                 "--pressure-factor --mass-factor --ambient-pressure --ambient-density",
                 {"--times", "--time", "time", false},
                 "moraine blast pulse --pressure \"100 kPa\" --duration \"5 ms\" --impulse \"180 "
                 "kPa ms\"\n"
                 "moraine blast pulse --charge \"10 kg\" --distance \"5 m\" --times \"0 ms\" \"15 "
                 "ms\" 31 --csv pulse.csv"},
    TopicCommand{Topic::line, "beside a long charge", "--charge --length --distance",
                 "--explosive --pressure-factor --mass-factor --ambient-pressure "
                 "--ambient-density --gauges --gauge",
                 over_distance,
                 "moraine blast line --charge \"10 kg\" --length \"20 m\" --distance \"3 m\""},
    TopicCommand{Topic::contact, "the impulse of a charge on a target",
                 "--charge --side-a --side-b --height",
                 "--explosive --pressure-factor --mass-factor", over_charge,
                 "moraine blast contact --charge \"2 kg\" --side-a \"15 cm\" --side-b \"10 cm\" "
                 "--height \"8 cm\""},
    TopicCommand{Topic::buried, "pressure and impulse in the ground", "--charge --distance --soil",
                 "--depth --coupling --explosive --pressure-factor --mass-factor", over_distance,
                 "moraine blast buried --charge \"10 kg\" --soil loam --depth \"2 m\" --distance "
                 "\"5 m\"\n"
                 "moraine blast buried --charge \"10 kg\" --soil dense_sand --coupling 0.6 "
                 "--distances \"2 m\" \"10 m\" 9"},
    TopicCommand{Topic::displacement, "how far the ground moves", "--charge --distance --ground",
                 "--mass-factor --explosive", over_distance,
                 "moraine blast displacement --charge \"10 kg\" --ground sand --distance \"4 m\" "
                 "--units imperial"},
    TopicCommand{Topic::crater, "crater, rupture radius and camouflet", "--charge",
                 "--ground --soil --depth --depth-factor --mass-factor --explosive", over_charge,
                 "moraine blast crater --charge \"10 kg\"\n"
                 "moraine blast crater --charge \"10 kg\" --ground clay --depth \"6 m\" --soil "
                 "silty_clay --depth-factor 0.8"},
    TopicCommand{Topic::water, "the shock of a charge under water", "--charge --distance",
                 "--time --explosive --pressure-factor --mass-factor --gauges --gauge",
                 over_distance,
                 "moraine blast water --charge \"50 kg\" --distance \"20 m\" --pressure-unit bar\n"
                 "moraine blast water --charge \"50 kg\" --distance \"20 m\" --time \"200 us\"\n"
                 "moraine blast water --charge \"50 kg\" --distances \"3 m\" \"100 m\" 30 --plot "
                 "water.png"},
    TopicCommand{Topic::bubble,
                 "the gas bubble of a charge under water",
                 "--charge --depth",
                 "--bubble-energy --water-density --surface-pressure --mass-factor --explosive",
                 {"--depths", "--depth", "depth", true},
                 "moraine blast bubble --charge \"50 kg\" --depth \"30 m\""},
};

}  // namespace

std::span<QuantityOption const> quantity_options() { return quantities; }
std::span<NameOption const> name_options() { return names; }
std::span<OutputUnitOption const> output_unit_options() { return output_units; }
std::span<TopicCommand const> topic_commands() { return commands; }

bool TopicCommand::uses(std::string_view flag) const {
  return holds(required, flag) || holds(optional, flag);
}

bool holds(std::string_view flags, std::string_view flag) {
  for (std::size_t at = flags.find(flag); at != std::string_view::npos;
       at = flags.find(flag, at + 1)) {
    std::size_t const end = at + flag.size();
    if ((at == 0 || flags[at - 1] == ' ') && (end == flags.size() || flags[end] == ' '))
      return true;
  }
  return false;
}

}  // namespace moraine
