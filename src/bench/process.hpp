// What the operating system knows about this process, and work in a process of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace moraine {

/// Memory of this process [bytes]: resident now, and the most that ever was.
struct ResidentMemory {
  std::size_t now = 0;
  std::size_t peak = 0;
};

/// From /proc/self/status (VmRSS, VmHWM). Throws std::runtime_error where there is no such file.
ResidentMemory resident_memory();

/// Processor time of all threads of this process [s].
double processor_seconds();

/// Name of the processor as the system spells it; "unknown" if it does not say.
std::string processor_name();

/// Runs `work` in a child process and returns its text: memory and threads start fresh. What
/// `work` throws arrives as std::runtime_error with the same text. Call it before the first
/// parallel loop of this process: threads do not survive a fork.
std::string in_child(std::function<std::string()> const& work);

}  // namespace moraine
