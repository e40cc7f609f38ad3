// The studies that `moraine reproduce` knows.
#include <array>

#include "app/published_study.hpp"

namespace moraine {
namespace {

constexpr std::string_view no_time = "the study prints no time";

constexpr std::array blast_soil{
    PublishedNumber{"surface-charge-4cm", "crater, rim to rim", "crater rim_diameter",
                    Taken::at_time, 200e-6, 0.38, "m", no_time},
    PublishedNumber{"surface-charge-4cm", "crater, depth", "crater depth", Taken::at_time, 200e-6,
                    0.15, "m", no_time},
    PublishedNumber{"surface-charge-6cm", "crater, rim to rim", "crater rim_diameter",
                    Taken::at_time, 200e-6, 0.52, "m", ""},
    PublishedNumber{"surface-charge-6cm", "crater, depth", "crater depth", Taken::at_time, 200e-6,
                    0.24, "m", ""},
    PublishedNumber{"surface-charge-10cm", "crater, rim to rim", "crater rim_diameter",
                    Taken::at_time, 100e-6, 0.58, "m", ""},
    PublishedNumber{"surface-charge-10cm", "crater, depth", "crater depth", Taken::at_time, 100e-6,
                    0.32, "m", ""},
    PublishedNumber{"surface-charge-4cm", "peak at C, 25 cm below", "C pressure", Taken::largest,
                    0.0, 8e6, "Pa", "read off a curve"},
    PublishedNumber{"surface-charge-10cm", "peak at A, 15 cm below", "A pressure", Taken::largest,
                    0.0, 40e6, "Pa", "read off a curve"},
    PublishedNumber{"surface-charge-4cm", "time of the peak at A", "A pressure",
                    Taken::time_of_largest, 0.0, 500e-6, "s", "read off a curve"},
    PublishedNumber{"surface-charge-6cm", "time of the peak at A", "A pressure",
                    Taken::time_of_largest, 0.0, 300e-6, "s", "read off a curve"},
    PublishedNumber{"surface-charge-10cm", "time of the peak at A", "A pressure",
                    Taken::time_of_largest, 0.0, 70e-6, "s", "read off a curve"},
    PublishedNumber{"surface-charge-4cm", "time of the peak at E", "E pressure",
                    Taken::time_of_largest, 0.0, 900e-6, "s", "read off a curve"},
    PublishedNumber{"surface-charge-6cm", "time of the peak at E", "E pressure",
                    Taken::time_of_largest, 0.0, 700e-6, "s", "read off a curve"},
    PublishedNumber{"surface-charge-10cm", "time of the peak at E", "E pressure",
                    Taken::time_of_largest, 0.0, 400e-6, "s", "read off a curve"},
};

constexpr std::string_view blast_soil_reasons =
    R"(Arrivals. The study's own soil has a speed of sound of 1440 m/s (its C), so that no peak can be at A,
15 cm below the ground, later than a wave of 15 cm / 1440 m/s = 104 us would be - unless the peak is not that
of the first wave. Its times of peaks at A and E mean 300 to 600 m/s between them. Its stated time step of
10 us at 1 cm would let products of 7 to 8 km/s pass seven particles in a step: its time axis cannot be
taken at face value, and with it the times that its craters belong to.

Peaks. In plane strain the peak of a shock falls with distance and width of the charge; ours are those of
particles 1 cm apart and rise with the resolution. The study's are lower by about the factor that its late
arrivals would explain: a slow wave of the same momentum is a weak one.

Craters. They are holes that still grow at these times; what is compared is one moment of a motion, and
a shift of the time axis shifts the size.
)";

constexpr std::array studies{
    PublishedStudy{"blast-soil",
                   "a doctoral thesis on explosions in granular soil with SPH (2017), surface "
                   "charges on loose sand; values as printed or read off its curves",
                   blast_soil, blast_soil_reasons}};

}  // namespace

std::span<PublishedStudy const> published_studies() { return studies; }

}  // namespace moraine
