// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcm::fast {

/// Values for some of the indices 0 .. size - 1, forgotten all at once in constant time: each entry carries the number
/// of the round it was written in. An evaluation so touches only the parts of a surface that its contact touches.
/// Grows to the largest size asked for and never shrinks.
template <class Value>
class FastClearArray {
 public:
  /// Forgets all values and makes room for `size` of them.
  void start(std::size_t size) {
    if (entries_.size() < size) entries_.resize(size);
    if (++round_ != 0) return;
    // Once in 2^32 rounds the numbers start anew.
    for (Entry& entry : entries_) entry.round = 0;
    round_ = 1;
  }

  template <class Int>
  bool contains(Int index) const {
    return entries_[static_cast<std::size_t>(index)].round == round_;
  }

  /// The value at `index`, `otherwise` where there is none.
  template <class Int>
  Value get(Int index, Value otherwise) const {
    const Entry& entry = entries_[static_cast<std::size_t>(index)];
    return entry.round == round_ ? entry.value : otherwise;
  }

  /// The value at `index`, where there is one.
  template <class Int>
  const Value& at(Int index) const {
    return entries_[static_cast<std::size_t>(index)].value;
  }

  template <class Int>
  void set(Int index, const Value& value) {
    Entry& entry = entries_[static_cast<std::size_t>(index)];
    entry.round = round_;
    entry.value = value;
  }

  /// Enters the value where there is none. Whether that was so: told without a branch.
  template <class Int>
  bool insert(Int index, const Value& value) {
    Entry& entry = entries_[static_cast<std::size_t>(index)];
    const bool fresh = entry.round != round_;
    entry.value = fresh ? value : entry.value;
    entry.round = round_;
    return fresh;
  }

  /// The value at `index`, made by default construction where there was none.
  template <class Int>
  Value& operator[](Int index) {
    Entry& entry = entries_[static_cast<std::size_t>(index)];
    if (entry.round != round_) entry = {round_, Value{}};
    return entry.value;
  }

 private:
  struct Entry {
    std::uint32_t round = 0;
    Value value{};
  };
  std::vector<Entry> entries_;
  std::uint32_t round_ = 1;
};

}  // namespace pcm::fast
