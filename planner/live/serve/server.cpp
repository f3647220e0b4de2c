#include "planner/live/serve/server.h"

#include <algorithm>
#include <array>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <mutex>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include "planner/live/serve/connection.h"
#include "planner/live/serve/line_client.h"
#include "planner/live/serve/token.h"
#include "planner/live/serve/utf8.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using Tcp = net::ip::tcp;
using ErrorCode = boost::system::error_code;

std::chrono::steady_clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(seconds));
}

// Lines of text over TCP.
class LineConnection final : public LineClient {
 public:
  LineConnection(ConnectionContext ground, Tcp::socket socket, const LineListener& listener,
                 const ServerOptions& options)
      : LineClient(std::move(ground), listener, options.token),
        socket_(std::move(socket)),
        deadline_(socket_.get_executor()),
        handshake_(duration_of(options.handshake_time)) {}

 private:
  std::shared_ptr<LineConnection> self() {
    return std::static_pointer_cast<LineConnection>(shared_from_this());
  }

  void open() override {
    ErrorCode ignored;
    // Replies are short and waited for; a client that vanished without a word is noticed some day.
    socket_.set_option(Tcp::no_delay(true), ignored);
    socket_.set_option(net::socket_base::keep_alive(true), ignored);
    welcome();
    read();
  }

  void close() override {
    ErrorCode ignored;
    socket_.close(ignored);
    deadline_.cancel();
  }

  void write(std::string& message) override {
    message += '\n';
    net::async_write(socket_, net::buffer(message),
                     [self = self()](ErrorCode error, std::size_t) { self->written(!error); });
  }

  void read() {
    if (is_finished()) return;
    socket_.async_read_some(net::buffer(piece_),
                            [self = self()](ErrorCode error, std::size_t size) {
                              if (self->is_finished()) return;
                              if (error == net::error::eof) return self->use_end();
                              if (error) return self->end();
                              self->use_bytes({self->piece_.data(), size});
                              self->read();
                            });
  }

  // Closing a socket with unread bytes would take the last lines back that are on their way. Its
  // time is limited already.
  void part() override {
    ErrorCode ignored;
    socket_.shutdown(Tcp::socket::shutdown_send, ignored);
    drain();
  }

  void drain() {
    socket_.async_read_some(net::buffer(piece_), [self = self()](ErrorCode error, std::size_t) {
      if (self->is_over()) return;
      if (error) return self->end();
      self->drain();
    });
  }

  void limit_time() override {
    deadline_.expires_after(handshake_);
    deadline_.async_wait([self = self()](ErrorCode) {
      // Also called when the time is changed, and it may be on its way already then.
      if (self->deadline_.expiry() <= std::chrono::steady_clock::now()) self->end();
    });
  }

  void unlimit_time() override {
    deadline_.expires_at(std::chrono::steady_clock::time_point::max());
  }

  Tcp::socket socket_;
  net::steady_timer deadline_;
  std::chrono::steady_clock::duration handshake_;
  std::array<char, 16384> piece_{};
};

// A stream whose WebSocket does not wait at its end for the other side to close, which may be
// never.
class PromptStream : public beast::tcp_stream {
 public:
  explicit PromptStream(beast::tcp_stream&& stream) : beast::tcp_stream(std::move(stream)) {}
};

// Beast finds these two by their names.
void teardown(beast::role_type, PromptStream& stream, ErrorCode& error) {
  stream.socket().shutdown(Tcp::socket::shutdown_both, error);
}

template <typename Handler>
void async_teardown(beast::role_type role, PromptStream& stream, Handler&& handler) {
  ErrorCode error;
  teardown(role, stream, error);
  net::post(stream.get_executor(),
            beast::bind_front_handler(std::forward<Handler>(handler), error));
}

// Whether a field came more than once that a request has one of (RFC 9110; of WebSockets RFC 6455).
// What stands between a browser and this server may go by the other one.
bool repeats_a_field(const http::fields& header) {
  constexpr std::array kSingle = {http::field::host,
                                  http::field::origin,
                                  http::field::content_length,
                                  http::field::transfer_encoding,
                                  http::field::upgrade,
                                  http::field::sec_websocket_key,
                                  http::field::sec_websocket_version};
  return std::any_of(kSingle.begin(), kSingle.end(),
                     [&](http::field field) { return header.count(field) > 1; });
}

// One HTTP request, and its answer or a WebSocket.
class HttpConnection final : public Connection {
 public:
  HttpConnection(ConnectionContext ground, Tcp::socket socket, const HttpListener& listener,
                 const HttpRules& rules, const ServerOptions& options)
      : Connection(std::move(ground)),
        stream_(std::move(socket)),
        listener_(listener),
        rules_(rules),
        options_(options) {}

 private:
  std::shared_ptr<HttpConnection> self() {
    return std::static_pointer_cast<HttpConnection>(shared_from_this());
  }

  void open() override {
    constexpr std::uint32_t kLargestHeader = 8192;
    parser_.header_limit(kLargestHeader);
    stream_.expires_after(duration_of(options_.handshake_time));
    // No request that is answered has a body, so that none is read.
    http::async_read_header(stream_, buffer_, parser_,
                            [self = self()](ErrorCode error, std::size_t) {
                              if (!self->is_over()) self->answer(error);
                            });
  }

  void close() override {
    if (socket_) {
      socket_->next_layer().close();
    } else {
      stream_.close();
    }
  }

  void answer(ErrorCode error) {
    if (error == http::error::end_of_stream) return end();
    if (error == http::error::header_limit) return reply({431});
    if (error.category() == http::make_error_code(http::error::bad_method).category()) {
      return reply({400});
    }
    if (error) return end();
    const auto& message = parser_.get();
    HttpRequest request;
    request.method = {message.method_string().data(), message.method_string().size()};
    request.target = {message.target().data(), message.target().size()};
    request.repeats = repeats_a_field(message);
    const auto host = message[http::field::host];
    request.host = {host.data(), host.size()};
    if (message.count(http::field::origin) > 0) {
      const auto origin = message[http::field::origin];
      request.origin = {origin.data(), origin.size()};
    }
    request.is_upgrade = websocket::is_upgrade(message);
    const HttpAnswer answer = answer_to(request, rules_, listener_.pages);
    if (answer.upgrade) return upgrade();
    reply(answer);
  }

  void reply(const HttpAnswer& answer) {
    reply_.result(static_cast<unsigned>(answer.status));
    reply_.keep_alive(false);
    for (const auto& [name, value] : safety_headers(listener_)) reply_.set(name, value);
    if (answer.status == 405) reply_.set(http::field::allow, "GET, HEAD");
    std::string_view body;
    if (answer.page != nullptr) {
      reply_.set(http::field::content_type, answer.page->content_type);
      body = answer.page->body;
    }
    reply_.content_length(body.size());
    if (parser_.get().method() != http::verb::head) reply_.body() = {body.data(), body.size()};
    http::async_write(stream_, reply_, [self = self()](ErrorCode error, std::size_t) {
      if (self->is_over()) return;
      if (error) return self->end();
      self->stream_.socket().shutdown(Tcp::socket::shutdown_send, error);
      self->drain();
    });
  }

  // Closing a socket with unread bytes would take the answer back that is on its way.
  void drain() {
    buffer_.clear();
    stream_.async_read_some(buffer_.prepare(4096), [self = self()](ErrorCode error, std::size_t) {
      if (self->is_over()) return;
      if (error) return self->end();
      self->drain();
    });
  }

  void upgrade() {
    socket_.emplace(std::move(stream_));
    socket_->next_layer().expires_never();
    socket_->set_option(websocket::stream_base::timeout{duration_of(options_.handshake_time),
                                                        duration_of(options_.idle_time), true});
    socket_->read_message_max(listener_.largest_message);
    socket_->auto_fragment(false);
    socket_->text(true);
    buffer_.clear();
    socket_->async_accept(parser_.get(), [self = self()](ErrorCode error) {
      if (self->is_over()) return;
      if (error) return self->end();
      if (self->join()) self->read();
    });
  }

  void read() {
    socket_->async_read(buffer_, [self = self()](ErrorCode error, std::size_t) {
      if (self->is_over()) return;
      if (error) return self->end();
      self->use_message();
    });
  }

  void use_message() {
    std::string message = beast::buffers_to_string(buffer_.data());
    buffer_.clear();
    buffer_.shrink_to_fit();
    if (socket_->got_binary() && !is_utf8(message)) {
      say(json_error_line("not UTF-8"));
    } else if (!deliver(std::move(message))) {
      return;
    }
    read();
  }

  void write(std::string& message) override {
    socket_->async_write(net::buffer(message),
                         [self = self()](ErrorCode error, std::size_t) { self->written(!error); });
  }

  beast::tcp_stream stream_;
  std::optional<websocket::stream<PromptStream>> socket_;  // once stream_ was upgraded
  beast::flat_buffer buffer_;
  http::request_parser<http::empty_body> parser_;
  http::response<http::span_body<const char>> reply_;
  const HttpListener& listener_;
  const HttpRules& rules_;
  const ServerOptions& options_;
};

}  // namespace

class Server::Impl {
 public:
  explicit Impl(ServerOptions options)
      : options_(std::move(options)), io_(std::in_place, options_.threads) {
    if (options_.token.empty()) options_.token = random_token();
    check_options(options_);
    rules_.token = options_.token;
  }

  ServerPorts start() {
    ServerPorts ports;
    if (options_.http) {
      rules_.port = open_door("http", options_.http->port, kFullHttp, [this](Tcp::socket socket) {
        Connection::ConnectionContext ground = ground_of(*options_.http->endpoint, socket);
        return std::make_shared<HttpConnection>(std::move(ground), std::move(socket),
                                                *options_.http, rules_, options_);
      });
      rules_.hosts = hosts_of(options_);
      ports.http = rules_.port;
    }
    for (std::size_t i = 0; i < options_.lines.size(); ++i) {
      const LineListener& listener = options_.lines[i];
      const auto make = [this, &listener](Tcp::socket socket) {
        Connection::ConnectionContext ground = ground_of(*listener.endpoint, socket);
        return std::make_shared<LineConnection>(std::move(ground), std::move(socket), listener,
                                                options_);
      };
      ports.lines.push_back(open_door("lines[" + std::to_string(i) + "]", listener.port,
                                      listener.refusal("too many clients") + "\n", make));
    }
    for (const std::unique_ptr<Acceptor>& door : doors_) accept(*door);
    for (int i = 0; i < options_.threads; ++i) threads_.emplace_back([this] { io_->run(); });
    return ports;
  }

  void stop() {
    const std::lock_guard once(stopping_);
    if (!io_) return;
    io_->stop();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    doors_.clear();
    // Nothing else runs any more, and ending a connection takes it out of the set.
    while (!connections_.empty()) (*connections_.begin())->end();
    // Connections that were accepted and have not been looked at are closed with it.
    io_.reset();
  }

  const std::string& token() const { return options_.token; }

  std::size_t connections() const {
    const std::lock_guard lock(lock_);
    return connections_.size();
  }

 private:
  static constexpr const char* kFullHttp =
      "HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 0\r\n\r\n";

  using Make = std::function<std::shared_ptr<Connection>(Tcp::socket)>;

  // Where clients come in.
  struct Acceptor {
    Tcp::acceptor acceptor;
    net::steady_timer pause;
    std::string full;  // what one too many is told
    Make make;
  };

  std::uint16_t open_door(const std::string& name, std::uint16_t port, std::string full,
                          Make make) {
    const Tcp::endpoint place(net::ip::make_address(options_.address), port);
    Tcp::acceptor acceptor(*io_);
    ErrorCode error;
    acceptor.open(place.protocol(), error);
    // A server that starts again takes its port back from connections that have just ended.
    if (!error) acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(place, error);
    if (!error) acceptor.listen(net::socket_base::max_listen_connections, error);
    if (error) {
      // The ports that are open already are not left so.
      doors_.clear();
      const bool is_port = error != boost::system::errc::address_not_available;
      throw InputError({.field = is_port ? name + ".port" : "address",
                        .problem = "cannot be opened: " + error.message(),
                        .value = is_port ? std::to_string(port) : options_.address});
    }
    const std::uint16_t opened = acceptor.local_endpoint().port();
    doors_.push_back(std::make_unique<Acceptor>(
        Acceptor{std::move(acceptor), net::steady_timer(*io_), std::move(full), std::move(make)}));
    return opened;
  }

  void accept(Acceptor& door) {
    door.acceptor.async_accept(net::make_strand(*io_),
                               [this, &door](ErrorCode error, Tcp::socket socket) {
                                 if (!error) {
                                   admit(door, std::move(socket));
                                   return accept(door);
                                 }
                                 // Such as: no more file descriptors. There may be some again soon.
                                 door.pause.expires_after(std::chrono::milliseconds(50));
                                 door.pause.async_wait([this, &door](ErrorCode) { accept(door); });
                               });
  }

  void admit(Acceptor& door, Tcp::socket socket) {
    if (connections() >= options_.clients) {
      // Fits into the empty buffer of a new socket; if it does not, it is left out.
      ErrorCode ignored;
      socket.non_blocking(true, ignored);
      socket.write_some(net::buffer(door.full), ignored);
      return;
    }
    const Tcp::socket::executor_type strand = socket.get_executor();
    const std::shared_ptr<Connection> connection = door.make(std::move(socket));
    {
      const std::lock_guard lock(lock_);
      connections_.insert(connection);
    }
    net::dispatch(strand, [connection] { connection->begin(); });
  }

  Connection::ConnectionContext ground_of(Endpoint& endpoint, Tcp::socket& socket) {
    return {endpoint, options_.largest_waiting,
            [strand = socket.get_executor()](std::function<void()> task) {
              net::post(strand, std::move(task));
            },
            [this](const std::shared_ptr<Connection>& connection) {
              const std::lock_guard lock(lock_);
              connections_.erase(connection);
            }};
  }

  ServerOptions options_;
  HttpRules rules_;
  std::optional<net::io_context> io_;  // until stop()
  // After io_, which they stand on.
  std::vector<std::unique_ptr<Acceptor>> doors_;
  std::vector<std::thread> threads_;
  std::mutex stopping_;
  mutable std::mutex lock_;  // of connections_
  std::set<std::shared_ptr<Connection>> connections_;
};

Server::Server(ServerOptions options) : hub_(std::make_unique<Impl>(std::move(options))) {}
// A thread that cannot be joined is a bug.
// NOLINTNEXTLINE(bugprone-exception-escape)
Server::~Server() { hub_->stop(); }
ServerPorts Server::start() { return hub_->start(); }
void Server::stop() { hub_->stop(); }
const std::string& Server::token() const { return hub_->token(); }
std::size_t Server::connections() const { return hub_->connections(); }

}  // namespace prehend
