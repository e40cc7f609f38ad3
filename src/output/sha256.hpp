// The SHA-256 digest, to name a case file by its content.
#pragma once

#include <string>
#include <string_view>

namespace moraine {

/// Digest of the bytes as 64 lower-case hexadecimal digits, as `sha256sum` prints it.
/// FIPS 180-4, "Secure Hash Standard", sections 4.1.2, 5.1.1 and 6.2.2.
std::string sha256(std::string_view bytes);

}  // namespace moraine
