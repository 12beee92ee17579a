// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "simulate/integrators/counted_equation.h"

namespace pcm::simulate {

/// SUNDIALS' objects, each freed by the function that is for it.
template <auto Free>
struct FreedBy {
  template <typename T>
  void operator()(T* object) const {
    Free(object);
  }
};
inline void free_context(SUNContext context) {
  SUNContext_Free(&context);
}
using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreedBy<free_context>>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreedBy<N_VDestroy>>;
using Matrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, FreedBy<SUNMatDestroy>>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, FreedBy<SUNLinSolFree>>;
using NonlinearSolver = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreedBy<SUNNonlinSolFree>>;

/// For what fails only without memory, or by an error of ours.
inline void require(bool success, const char* what) {
  if (!success) throw std::runtime_error(std::string("SUNDIALS: ") + what + " failed");
}

inline Context make_context() {
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context) == 0, "SUNContext_Create");
  return Context(context);
}

inline Eigen::Map<Eigen::VectorXd> values(N_Vector vector) {
  return {N_VGetArrayPointer(vector), N_VGetLength(vector)};
}

inline Vector make_vector(const Eigen::VectorXd& from, const Context& context) {
  Vector vector(N_VNew_Serial(from.size(), context.get()));
  require(vector != nullptr, "N_VNew_Serial");
  values(vector.get()) = from;
  return vector;
}

/// Newton's iteration solves dense systems directly.
struct DenseSystem {
  DenseSystem(const Vector& like, Eigen::Index size, const Context& context)
      : matrix(SUNDenseMatrix(size, size, context.get())),
        solver(SUNLinSol_Dense(like.get(), matrix.get(), context.get())) {
    require(matrix && solver, "SUNLinSol_Dense");
  }
  Matrix matrix;
  LinearSolver solver;
};

/// What callbacks are given as their user_data.
struct Callbacks {
  CountedEquation& equation;
  std::string message;  ///< SUNDIALS' last error
};

inline Callbacks& callbacks_of(void* user_data) {
  return *static_cast<Callbacks*>(user_data);
}

/// SUNDIALS prints nothing: its errors are kept, its warnings (positive codes) dropped.
inline void keep_message(int code, const char*, const char*, char* message, void* user_data) {
  if (code < 0) callbacks_of(user_data).message = message;
}

/// f for CVODE and ARKODE.
inline int derivative_callback(double t, N_Vector y, N_Vector dydt, void* user_data) {
  return static_cast<int>(
      callbacks_of(user_data).equation.derivative(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dydt)));
}

/// df/dy for CVODE and ARKODE.
inline int jacobian_callback(double t, N_Vector y, N_Vector dydt, SUNMatrix J, void* user_data, N_Vector, N_Vector,
                             N_Vector) {
  return static_cast<int>(callbacks_of(user_data).equation.jacobian(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dydt),
                                                                    SUNDenseMatrix_Data(J)));
}

}  // namespace pcm::simulate
