#pragma once
// The newest report in a browser of this machine.

#include <memory>
#include <string>

namespace cli {

// Answers on 127.0.0.1 alone, on a port that the system chooses, and only who knows the address,
// which holds 128 random bits: pages of others neither find nor read it. The page loads the report
// again whenever there is a new one.
class ReportServer {
 public:
  // Null: no port can be had; `problem` says why.
  static std::unique_ptr<ReportServer> start(std::string& problem);
  ~ReportServer();
  ReportServer(const ReportServer&) = delete;
  ReportServer& operator=(const ReportServer&) = delete;

  // "http://127.0.0.1:41234/3f...e1/"
  const std::string& address() const;
  // From now on this is the report: HTML.
  void show(std::string html);

 private:
  ReportServer();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cli
