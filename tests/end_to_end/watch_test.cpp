// `moraine watch`, status.json and snapshots of a run that is going on.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "end_to_end/small_case.hpp"
#include "output/vtp_reader.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

using namespace std::chrono_literals;

class Watch : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("case.toml"), small_case("end = 0.02, courant = 0.2"));
    write(path("long.toml"), small_case("end = 1000.0, courant = 0.2"));
  }
  template <class Condition>
  static bool within_ten_seconds(Condition condition) {
    for (int tries = 0; tries < 1000; ++tries) {
      if (condition()) return true;
      std::this_thread::sleep_for(10ms);
    }
    return false;
  }
  nlohmann::json status(std::string const& folder) const {
    auto json = nlohmann::json::parse(bytes_of(path(folder) / "status.json"), nullptr, false);
    return json.is_object() ? json : nlohmann::json::object();
  }
  /// What a server on the loopback answers to a request as it stands.
  static std::string answer(int port, std::string const& request) {
    int const s = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    std::string text;
    if (connect(s, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
        ::write(s, request.data(), request.size()) == static_cast<ssize_t>(request.size())) {
      char buffer[65536];
      for (ssize_t n = 0; (n = read(s, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(n));
    }
    close(s);
    return text;
  }
  static std::string get(int port, std::string const& target, std::string const& host = "127.0.0.1",
                         char const* method = "GET") {
    return answer(port, std::string(method) + ' ' + target + " HTTP/1.1\r\nHost: " + host + ':' +
                            std::to_string(port) + "\r\nConnection: close\r\n\r\n");
  }
  static nlohmann::json body(std::string const& response) {
    return nlohmann::json::parse(response.substr(response.find("\r\n\r\n") + 4), nullptr, false);
  }
};

TEST_F(Watch, StatusTellsProgramsHowItEnded) {
  ASSERT_EQ(moraine_command(path(""), {"run", "case.toml", "-o", "done"}).code, 0);
  auto const end = status("done");
  EXPECT_EQ(end.at("state"), "ended");
  EXPECT_EQ(end.at("time_s"), 0.02);
  std::uint64_t steps = 0;
  for (auto const& vote : end.at("votes")) steps += vote.at("steps").get<std::uint64_t>();
  EXPECT_EQ(steps, end.at("step").get<std::uint64_t>());
  EXPECT_TRUE(std::filesystem::exists(path("done/report.html")));

  auto const shown = moraine_command(path(""), {"watch", "done"});
  EXPECT_EQ(shown.code, 0);
  EXPECT_NE(shown.out.find("small dam  (ended)"), std::string::npos) << shown.out;
  EXPECT_NE(shown.out.find("100 %"), std::string::npos) << shown.out;
  EXPECT_EQ(moraine_command(path(""), {"watch", "nothing"}).code, 2);
}

TEST_F(Watch, SnapshotIsTakenOnRequest) {
  Program run(path(""), {"run", "long.toml", "-o", "long"});
  ASSERT_TRUE(within_ten_seconds([&] { return status("long").value("step", 0) > 0; }));
  EXPECT_EQ(status("long").at("state"), "running");
  write(path("long/snapshot"), "");
  std::filesystem::path found;
  EXPECT_TRUE(within_ten_seconds([&] {
    std::error_code none;
    for (auto const& entry : std::filesystem::directory_iterator(path("long/snapshots"), none))
      if (entry.path().extension() == ".vtp") found = entry.path();
    return !found.empty();
  }));
  EXPECT_FALSE(std::filesystem::exists(path("long/snapshot"))) << "the request is taken away";
  EXPECT_EQ(read_vtp(found).size, 150u);
  run.send(SIGTERM);
  EXPECT_EQ(run.wait().code, 130);
  EXPECT_EQ(status("long").at("state"), "stopped");
}

TEST_F(Watch, ServesThePageToThisMachineAlone) {
  Program run(path(""), {"run", "long.toml", "-o", "long"});
  ASSERT_TRUE(within_ten_seconds([&] { return status("long").value("step", 0) > 0; }));
  Program watch(path("long"), {"watch", ".", "--web"});
  int port = 0;
  ASSERT_TRUE(within_ten_seconds([&] {
    std::string const said = bytes_of(path("long/out"));
    auto const at = said.find("http://127.0.0.1:");
    if (at != std::string::npos && said.find("/  ") != std::string::npos)
      port = std::stoi(said.substr(at + 17));
    return port > 0;
  }));
  std::string const page = get(port, "/");
  EXPECT_NE(page.find("200 OK"), std::string::npos);
  EXPECT_NE(page.find("data.json"), std::string::npos);
  std::string const data = get(port, "/data.json");
  EXPECT_EQ(body(data).at("runs").at(0).at("state"), "running");
  EXPECT_FALSE(body(data).at("blocks").empty());
  EXPECT_NE(get(port, "/", "evil.example").find("403"), std::string::npos);
  EXPECT_NE(get(port, "/manifest.json").find("404"), std::string::npos);
  EXPECT_NE(get(port, "/../case.toml").find("404"), std::string::npos);
  EXPECT_TRUE(get(port, "/data.json", "127.0.0.1", "POST").starts_with("HTTP/1.1 4"));

  run.send(SIGTERM);
  run.wait();
  std::string last;
  EXPECT_TRUE(within_ten_seconds([&] {
    last = get(port, "/data.json");
    return body(last).at("runs").at(0).at("state") == "stopped";
  }));
  std::string const revision = std::to_string(body(last).at("revision").get<int>());
  EXPECT_NE(get(port, "/data.json?since=" + revision).find("304"), std::string::npos)
      << "nothing has changed";
  watch.send(SIGINT);
  EXPECT_EQ(watch.wait().code, 0);
}

}  // namespace
}  // namespace moraine
