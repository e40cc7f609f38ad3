#include "watch/live_server.hpp"

#include <fmt/core.h>
#include <httplib.h>

#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>

#include "output/run_lock.hpp"
#include "report/report.hpp"

namespace moraine::watch {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double interval = 1.0;  // s, between two questions of a page

/// Changes whenever a run has written something.
std::string fingerprint(std::filesystem::path const& folder) {
  // A run that was killed writes nothing any more; that nobody holds its lock is all that changes.
  std::string print = RunLock::is_held(folder) ? "held;" : "free;";
  for (char const* const name :
       {"status.json", "manifest.json", "gauges.csv", "sums.csv", "particles.pvd"}) {
    std::error_code none;
    auto const file = folder / name;
    print += fmt::format("{} {};", std::filesystem::file_size(file, none),
                         std::filesystem::last_write_time(file, none).time_since_epoch().count());
  }
  return print;
}

/// A page of another site must not read the run by a name of its own for this address.
bool is_for_this_machine(httplib::Request const& request) {
  std::string host = request.get_header_value("Host");
  host = host.substr(0, host.rfind(':'));
  return host == "127.0.0.1" || host == "localhost";
}

}  // namespace

struct LiveServer::Inside {
  explicit Inside(std::filesystem::path run) : folder(std::move(run)) {
    server.set_default_headers({{"Cache-Control", "no-store"},
                                {"X-Content-Type-Options", "nosniff"},
                                {"Referrer-Policy", "no-referrer"}});
    server.set_pre_routing_handler(
        [](httplib::Request const& request, httplib::Response& response) {
          if (is_for_this_machine(request)) return httplib::Server::HandlerResponse::Unhandled;
          response.status = 403;
          return httplib::Server::HandlerResponse::Handled;
        });
    server.Get("/", [this](httplib::Request const&, httplib::Response& response) {
      response.set_content(report::live_page(folder.filename().string(), interval),
                           "text/html; charset=utf-8");
    });
    server.Get("/data.json", [this](httplib::Request const& request, httplib::Response& response) {
      answer(request.get_param_value("since"), response);
    });
  }

  void answer(std::string const& since, httplib::Response& response) {
    std::lock_guard const alone(making);
    try {
      if (std::string now = fingerprint(folder); now != made_of && Clock::now() >= not_before) {
        auto const start = Clock::now();
        auto json = report::live_data(folder);
        json["revision"] = ++revision;
        data = json.dump(-1, ' ', false, report::Json::error_handler_t::replace);
        made_of = std::move(now);
        // Large runs take long to read: the run that is watched shall keep nine tenths of the time.
        not_before = Clock::now() + 9 * (Clock::now() - start);
      }
    } catch (std::exception const& error) {
      response.status = 503;  // files of a run that is just starting, or is being replaced
      response.set_content(error.what(), "text/plain; charset=utf-8");
      return;
    }
    if (since == std::to_string(revision))
      response.status = 304;
    else
      response.set_content(data, "application/json");
  }

  std::filesystem::path folder;
  httplib::Server server;
  std::mutex making;
  std::string made_of, data;
  int revision = 0;
  Clock::time_point not_before{};
};

LiveServer::LiveServer(std::filesystem::path folder)
    : inside_(std::make_unique<Inside>(std::move(folder))) {}

LiveServer::~LiveServer() = default;

int LiveServer::bind(int port) {
  constexpr char const* here = "127.0.0.1";
  if (port == 0) {
    port = inside_->server.bind_to_any_port(here);
    if (port > 0) return port;
  } else if (inside_->server.bind_to_port(here, port)) {
    return port;
  }
  throw std::runtime_error(fmt::format("port {} of {} is not to be had", port, here));
}

void LiveServer::serve() { inside_->server.listen_after_bind(); }

void LiveServer::stop() { inside_->server.stop(); }

}  // namespace moraine::watch
