// Sources that several relations name.
#pragma once

#include <string_view>

namespace moraine::blast {

inline constexpr std::string_view thesis_source =
    "2017 doctoral thesis on explosions in granular soil with SPH, ch. 3";
inline constexpr std::string_view kingery_source =
    "C. N. Kingery, G. Bulmash, ARBRL-TR-02555 (1984); ARL-TR-1310 (1997)";
inline constexpr std::string_view kinney_source =
    "G. F. Kinney, K. J. Graham, Explosive Shocks in Air, 2nd ed. (1985), ch. 6";
inline constexpr std::string_view rankine_source = "Rankine-Hugoniot conditions, gamma = 1.4";
inline constexpr std::string_view lampson_source =
    "C. W. Lampson, Explosions in earth, NDRC (1946); 2017 doctoral thesis on explosions in "
    "granular soil with SPH, ch. 3";
inline constexpr std::string_view cole_source = "R. H. Cole, Underwater Explosions (1948)";
inline constexpr std::string_view swisdak_water_source = "M. M. Swisdak, NSWC/WOL TR 76-116 (1978)";

}  // namespace moraine::blast
