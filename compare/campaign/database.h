// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace pcm::compare {

/// Throws BadInput: what the file holds was not written by us.
[[noreturn]] void throw_damaged(const std::filesystem::path& file);

/// A SQLite database in a file, which is made where there is none. Several processes may have it open; one that finds
/// it locked waits, a minute at most. All that fails throws BadInput naming the file. Not for two threads at a time.
class Database {
 public:
  explicit Database(std::filesystem::path file);

  const std::filesystem::path& file() const { return file_; }
  /// SQL without parameters and results.
  void run(const char* sql);
  /// How many rows the last statement changed.
  std::int64_t changes() const;

 private:
  friend class Statement;
  struct Closer {
    void operator()(sqlite3* handle) const;
  };

  [[noreturn]] void fail(int code) const;

  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Closer> handle_;
};

/// One statement, its parameters bound in their order.
class Statement {
 public:
  template <class... Parameters>
  Statement(Database& database, const char* sql, const Parameters&... parameters) : Statement(database, sql) {
    int place = 0;
    (bind(++place, parameters), ...);
  }
  Statement(Database& database, const char* sql);

  /// The next row; false at the end.
  bool step();
  /// For statements without rows.
  void run() {
    while (step()) continue;
  }
  std::int64_t integer(int column) const;
  std::string text(int column) const;

 private:
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };

  void bind(int place, std::int64_t value);
  void bind(int place, std::string_view value);

  Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
};

/// A transaction that no other process writes in; rolled back unless it is committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace pcm::compare
