#include "report/tools/watch/report_server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

namespace cli {
namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kMostBrowsers = 32;  // each waits for news on a thread of its own

// The report keeps its place where it is scrolled to.
constexpr const char* kPage = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>luxgate watch</title>
<style>html,body,iframe{{margin:0;border:0;width:100%;height:100%;display:block}}body{{overflow:hidden}}</style></head>
<body><iframe id="report" title="Report" src="report"></iframe>
<script nonce="{0}">
"use strict";
const frame = document.getElementById("report");
let y = 0;
frame.addEventListener("load", () => frame.contentWindow.scrollTo(0, y));
new EventSource("news?seen={1}").onmessage = () => {{
  y = frame.contentWindow.scrollY;
  frame.contentWindow.location.reload();
}};
</script></body></html>
)";

// What this process has open with browsers at that port of its own: calls visit(socket, the
// browser's port).
template <class Visit>
void for_each_connection(int port, Visit visit) {
  const long most = sysconf(_SC_OPEN_MAX);
  constexpr long kMostLooked = 4096;
  for (int socket = 0; socket < std::min(most, kMostLooked); ++socket) {
    sockaddr_in name{}, browser{};
    socklen_t size = sizeof name, browser_size = sizeof browser;
    if (getsockname(socket, reinterpret_cast<sockaddr*>(&name), &size) != 0) continue;
    if (name.sin_family != AF_INET || ntohs(name.sin_port) != port) continue;
    if (getpeername(socket, reinterpret_cast<sockaddr*>(&browser), &browser_size) != 0) continue;
    visit(socket, static_cast<int>(ntohs(browser.sin_port)));
  }
}

// Who sends a request byte by byte would otherwise keep a thread for as long as it likes.
void cut_connections(int port) {
  for_each_connection(port, [](int socket, int) { shutdown(socket, SHUT_RDWR); });
}

// A whole request waits to be read.
bool has_asked(int socket) {
  char bytes[8192];
  const ssize_t size = recv(socket, bytes, sizeof bytes, MSG_PEEK | MSG_DONTWAIT);
  return size > 0 && std::string_view(bytes, static_cast<std::size_t>(size)).find("\r\n\r\n") !=
                         std::string_view::npos;
}

// Of connections those whose whole request has come; the others are cut after a while. Any page of
// the web may open as many as it likes, and send headers without end.
class Guests {
 public:
  void welcome(int browser_port) {
    const std::lock_guard lock(mutex_);
    known_.insert(browser_port);
  }

  void cut_strangers(int port) {
    constexpr std::chrono::milliseconds kAtMost{1000};
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard lock(mutex_);
    std::map<int, std::chrono::steady_clock::time_point> waiting;
    std::set<int> known;
    for_each_connection(port, [&](int socket, int browser_port) {
      if (known_.contains(browser_port)) {
        known.insert(browser_port);
        return;
      }
      const auto since = waiting_.find(browser_port);
      const bool is_new = since == waiting_.end() || has_asked(socket);
      waiting[browser_port] = is_new ? now : since->second;
      if (now - waiting[browser_port] > kAtMost) shutdown(socket, SHUT_RDWR);
    });
    known_ = std::move(known);
    waiting_ = std::move(waiting);
  }

 private:
  std::mutex mutex_;
  std::set<int> known_;                                           // ports of browsers
  std::map<int, std::chrono::steady_clock::time_point> waiting_;  // since when
};

std::string random_words() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

// Which report a page had: what it asks with. 0, which no report has, if that is no number.
std::uint64_t version_in(const std::string& text) {
  std::uint64_t version = 0;
  std::from_chars(text.data(), text.data() + text.size(), version);
  return version;
}

}  // namespace

struct ReportServer::Parts {
  httplib::Server server;
  std::string token = random_words();
  std::string address, host;  // host: with the port, as browsers name it
  std::mutex mutex;
  std::condition_variable has_news;
  std::string html;
  std::uint64_t version = 0;
  bool is_ending = false;
  int port = 0;
  std::atomic<bool> has_ended{false};
  std::thread thread, doorkeeper;
  Guests guests;

  // Waits for another report than that of `seen`; false: the server ends.
  bool wait_for_news(std::uint64_t& seen, bool& is_new) {
    constexpr std::chrono::seconds kAtMost{10};
    std::unique_lock lock(mutex);
    has_news.wait_for(lock, kAtMost, [&] { return is_ending || version != seen; });
    is_new = version != seen;
    seen = version;
    return !is_ending;
  }

  void answer() {
    // Whoever connects and asks nothing must keep neither a thread nor the end of the program.
    server.set_keep_alive_timeout(1);
    server.set_read_timeout(2);
    server.new_task_queue = [] { return new httplib::ThreadPool(kMostBrowsers); };
    server.set_default_headers({{"Cache-Control", "no-store"},
                                {"Referrer-Policy", "no-referrer"},
                                {"Cross-Origin-Resource-Policy", "same-origin"},
                                {"X-Content-Type-Options", "nosniff"}});
    // A page of another name that leads here asks with that name.
    server.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
          if (request.get_header_value("Host") == host) {
            if (request.path.starts_with("/" + token + "/")) guests.welcome(request.remote_port);
            return httplib::Server::HandlerResponse::Unhandled;
          }
          response.status = 403;
          return httplib::Server::HandlerResponse::Handled;
        });
    server.Get("/" + token + "/", [this](const httplib::Request&, httplib::Response& response) {
      const std::string nonce = random_words();
      response.set_header("Content-Security-Policy",
                          fmt::format("default-src 'none'; style-src 'unsafe-inline'; script-src "
                                      "'nonce-{}'; connect-src 'self'; frame-src 'self'; "
                                      "frame-ancestors 'none'",
                                      nonce));
      const std::lock_guard lock(mutex);
      response.set_content(fmt::format(kPage, nonce, version), "text/html; charset=utf-8");
    });
    server.Get("/" + token + "/report",
               [this](const httplib::Request&, httplib::Response& response) {
                 const std::lock_guard lock(mutex);
                 response.set_content(html, "text/html; charset=utf-8");
               });
    server.Get("/" + token + "/news", [this](const httplib::Request& request,
                                             httplib::Response& response) {
      response.set_chunked_content_provider(
          "text/event-stream", [this, seen = version_in(request.get_param_value("seen"))](
                                   std::size_t, httplib::DataSink& sink) mutable {
            bool is_new = false;
            if (!wait_for_news(seen, is_new)) return false;
            const std::string event = is_new ? "data: report\n\n" : ": nothing new\n\n";
            return sink.write(event.data(), event.size());
          });
    });
  }
};

ReportServer::ReportServer() : parts_(std::make_unique<Parts>()) {}

std::unique_ptr<ReportServer> ReportServer::start(std::string& problem) {
  std::unique_ptr<ReportServer> server(new ReportServer);
  Parts& parts = *server->parts_;
  parts.port = parts.server.bind_to_any_port(kHost);
  if (parts.port <= 0) {
    problem = fmt::format("no free port at {}", kHost);
    return nullptr;
  }
  parts.host = fmt::format("{}:{}", kHost, parts.port);
  parts.address = fmt::format("http://{}/{}/", parts.host, parts.token);
  parts.answer();
  parts.thread = std::thread([&parts] {
    parts.server.listen_after_bind();
    parts.has_ended = true;
  });
  parts.doorkeeper = std::thread([&parts] {
    while (!parts.has_ended) {
      parts.guests.cut_strangers(parts.port);
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
  });
  // One that does not run yet cannot be stopped.
  constexpr int kMostWaits = 1000;
  for (int k = 0; k < kMostWaits && !parts.server.is_running(); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return server;
}

ReportServer::~ReportServer() {
  if (!parts_->thread.joinable()) return;
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->is_ending = true;
  }
  parts_->has_news.notify_all();
  parts_->server.stop();
  while (!parts_->has_ended) {
    cut_connections(parts_->port);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  parts_->thread.join();
  parts_->doorkeeper.join();
}

const std::string& ReportServer::address() const { return parts_->address; }

void ReportServer::show(std::string html) {
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->html = std::move(html);
    ++parts_->version;
  }
  parts_->has_news.notify_all();
}

}  // namespace cli
