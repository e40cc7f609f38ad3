// Marker of functions that run on the host and on a device.
#pragma once

#if defined(__CUDACC__)
#define MORAINE_HD __host__ __device__
#else
#define MORAINE_HD
#endif

/// Marker of formulas inside the pair loops: as MORAINE_HD, and always inlined. Without it
/// compilers stop inlining in the large fused loops, and vectors then travel through memory.
#if defined(__CUDACC__)
#define MORAINE_FORMULA MORAINE_HD __forceinline__
#else
#define MORAINE_FORMULA [[gnu::always_inline]] inline
#endif
