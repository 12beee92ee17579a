// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pcm::reference {

/// A vector of three numbers of any kind the oracle computes with: exact, rational, interval. Plain mathematics.
template <class T>
struct Vec3 {
  T x, y, z;

  const T& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(const T& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Determinant of the matrix with rows a, b, c.
template <class T>
T determinant(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  return dot(a, cross(b, c));
}

/// Twice the vector area of the triangle: points out of the body, length twice the area.
template <class T>
Vec3<T> doubled_normal(const Vec3<T>& p0, const Vec3<T>& p1, const Vec3<T>& p2) {
  return cross(p1 - p0, p2 - p0);
}

}  // namespace pcm::reference
