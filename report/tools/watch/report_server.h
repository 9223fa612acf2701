#pragma once
// Shows the newest report in a browser of this machine.

#include <memory>
#include <string>

namespace cli {

// Serves only 127.0.0.1, on a port chosen by the system, and only at its address, which contains
// 128 random bits: pages of others can neither find nor read it. The page reloads the report
// whenever there is a new one.
class ReportServer {
 public:
  // Starts the server. Null: no port is available; `problem` says why.
  static std::unique_ptr<ReportServer> start(std::string& problem);
  ~ReportServer();
  ReportServer(const ReportServer&) = delete;
  ReportServer& operator=(const ReportServer&) = delete;

  // Returns "http://127.0.0.1:41234/3f...e1/".
  const std::string& address() const;
  // Replaces the report: HTML.
  void show(std::string html);

 private:
  ReportServer();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cli
