// The commands of the program; each returns the exit code of the process.
#pragma once

#include <string>
#include <vector>

namespace moraine {

/// Exit codes: 0 done, 1 a check failed or something unexpected, 2 bad input or options, 3 the run
/// became unstable, 4 results could not be written, 130 interrupted.
enum ExitCode : int {
  done = 0,
  failed = 1,
  bad_input = 2,
  unstable = 3,
  not_written = 4,
  interrupted = 130
};

struct RunOptions {
  std::string case_file;
  std::string output;
  int threads = 0;     // 0: all
  bool force = false;  // replace the results of another run
};
int run_case(RunOptions const& options);

struct ResumeOptions {
  std::string folder;
  int threads = 0;  // 0: all
};
int resume_run(ResumeOptions const& options);

struct PreviewOptions {
  std::string case_file;
  std::string output;
};
int preview_case(PreviewOptions const& options);

struct PlotOptions {
  std::string folder;
  std::string field = "pressure";
};
int plot_folder(PlotOptions const& options);

struct SurfaceOptions {
  std::string folder;
  int frame = -1;  // -1: the last one
  bool all = false;
  std::string material;  // empty: all
  double share = 0.5;
};
int draw_surfaces(SurfaceOptions const& options);

struct BenchOptions {
  std::vector<std::string> names;  // empty: the usual workloads
  bool list = false;
  bool json = false;
  int threads = 0;   // 0: all
  int steps = 0;     // 0: as the workload says
  int warm_up = -1;  // -1: as the workload says
};
int run_bench(BenchOptions const& options);

struct VerifyOptions {
  std::vector<std::string> names;  // empty: all checks
  bool list = false;
  bool quick = false;
  bool json = false;
  int threads = 0;     // 0: all
  std::string report;  // file of a page; empty: none
};
int run_verify(VerifyOptions const& options);

}  // namespace moraine
