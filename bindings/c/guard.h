// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "pcm/bad_input.h"
#include "pcm/pcm.h"

/// Between C++, which throws, and C, which is told a status.
namespace pcm::c {

/// A call that the programmer can mend: PCM_BAD_CALL.
class BadCall : public std::logic_error {
  using std::logic_error::logic_error;
};

/// What is pointed to. Throws BadCall where nothing is.
template <class T>
T& given(T* pointer, const char* name) {
  if (pointer == nullptr) throw BadCall(std::string(name) + " is NULL");
  return *pointer;
}

/// Writes the text into the caller's memory, where there is any, as one line of UTF-8: with `?` for what has no
/// place there, and without its middle where it is too long.
void write_error(pcm_error* error, std::string_view text) noexcept;

/// Does it and tells what became of it; nothing is thrown.
template <class Action>
pcm_status guarded(pcm_error* error, const Action& action) noexcept {
  try {
    action();
    write_error(error, "");
    return PCM_OK;
  } catch (const BadInput& bad) {
    write_error(error, bad.what());
    return PCM_BAD_INPUT;
  } catch (const BadCall& bad) {
    write_error(error, bad.what());
    return PCM_BAD_CALL;
  } catch (const std::bad_alloc&) {
    write_error(error, "out of memory");
    return PCM_OUT_OF_MEMORY;
  } catch (const std::exception& bug) {
    write_error(error, bug.what());
  } catch (...) {
    write_error(error, "an exception of unknown kind");
  }
  return PCM_INTERNAL_ERROR;
}

}  // namespace pcm::c
