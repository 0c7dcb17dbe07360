// Vectors, quaternions, matrices and transforms of tf2.
#pragma once

#include <algorithm>
#include <cmath>

typedef double tf2Scalar;
#define TF2SIMD_FORCE_INLINE inline
#define TF2SIMD_PI 3.14159265358979323846
#define TF2SIMD_EPSILON 2.2204460492503131e-16

namespace tf2 {

class Vector3
{
public:
  double m_floats[4]{0, 0, 0, 0};

  Vector3() = default;
  Vector3(double x, double y, double z)
  : m_floats{x, y, z, 0} {}
  double x() const {return m_floats[0];}
  double y() const {return m_floats[1];}
  double z() const {return m_floats[2];}
  double getX() const {return x();}
  double getY() const {return y();}
  double getZ() const {return z();}
  void setX(double v) {m_floats[0] = v;}
  void setY(double v) {m_floats[1] = v;}
  void setZ(double v) {m_floats[2] = v;}
  void setValue(double a, double b, double c) {*this = Vector3(a, b, c);}
  void setZero() {*this = Vector3();}
  double & operator[](int i) {return m_floats[i];}
  const double & operator[](int i) const {return m_floats[i];}
  Vector3 & operator+=(const Vector3 & v) {return *this = *this + v;}
  Vector3 & operator-=(const Vector3 & v) {return *this = *this - v;}
  Vector3 & operator*=(double s) {return *this = *this * s;}
  Vector3 & operator/=(double s) {return *this = *this / s;}
  Vector3 operator-() const {return {-x(), -y(), -z()};}
  Vector3 operator+(const Vector3 & v) const {return {x() + v.x(), y() + v.y(), z() + v.z()};}
  Vector3 operator-(const Vector3 & v) const {return {x() - v.x(), y() - v.y(), z() - v.z()};}
  Vector3 operator*(const Vector3 & v) const {return {x() * v.x(), y() * v.y(), z() * v.z()};}
  Vector3 operator*(double s) const {return {x() * s, y() * s, z() * s};}
  Vector3 operator/(double s) const {return {x() / s, y() / s, z() / s};}
  friend Vector3 operator*(double s, const Vector3 & v) {return v * s;}
  bool operator==(const Vector3 & v) const {return x() == v.x() && y() == v.y() && z() == v.z();}
  bool operator!=(const Vector3 & v) const {return !(*this == v);}
  double dot(const Vector3 & v) const {return x() * v.x() + y() * v.y() + z() * v.z();}
  Vector3 cross(const Vector3 & v) const
  {
    return {y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x()};
  }
  double length2() const {return dot(*this);}
  double length() const {return std::sqrt(length2());}
  double distance2(const Vector3 & v) const {return (v - *this).length2();}
  double distance(const Vector3 & v) const {return (v - *this).length();}
  Vector3 & normalize() {return *this /= length();}
  Vector3 normalized() const {return *this / length();}
  double angle(const Vector3 & v) const {return std::acos(dot(v) / std::sqrt(length2() * v.length2()));}
  Vector3 absolute() const {return {std::abs(x()), std::abs(y()), std::abs(z())};}
  Vector3 lerp(const Vector3 & v, double t) const {return *this + (v - *this) * t;}
  bool isZero() const {return x() == 0 && y() == 0 && z() == 0;}
  bool fuzzyZero() const {return length2() < TF2SIMD_EPSILON;}
  double triple(const Vector3 & a, const Vector3 & b) const {return dot(a.cross(b));}
  int minAxis() const {return x() < y() ? (x() < z() ? 0 : 2) : (y() < z() ? 1 : 2);}
  int maxAxis() const {return x() < y() ? (y() < z() ? 2 : 1) : (x() < z() ? 2 : 0);}
  void setMax(const Vector3 & v) {*this = {std::max(x(), v.x()), std::max(y(), v.y()), std::max(z(), v.z())};}
  void setMin(const Vector3 & v) {*this = {std::min(x(), v.x()), std::min(y(), v.y()), std::min(z(), v.z())};}
  /// Turns around an axis of length 1.
  Vector3 rotate(const Vector3 & axis, double angle) const
  {
    const Vector3 along = axis * axis.dot(*this), across = *this - along;
    return along + across * std::cos(angle) + axis.cross(*this) * std::sin(angle);
  }
};

inline double tf2Dot(const Vector3 & a, const Vector3 & b) {return a.dot(b);}
inline Vector3 tf2Cross(const Vector3 & a, const Vector3 & b) {return a.cross(b);}
inline double tf2Distance(const Vector3 & a, const Vector3 & b) {return a.distance(b);}

class Quaternion
{
public:
  double m_floats[4]{0, 0, 0, 1};

  Quaternion() = default;
  Quaternion(double x, double y, double z, double w)
  : m_floats{x, y, z, w} {}
  Quaternion(const Vector3 & axis, double angle) {setRotation(axis, angle);}
  static const Quaternion & getIdentity()
  {
    static const Quaternion identity(0, 0, 0, 1);
    return identity;
  }
  double x() const {return m_floats[0];}
  double y() const {return m_floats[1];}
  double z() const {return m_floats[2];}
  double w() const {return m_floats[3];}
  double getX() const {return x();}
  double getY() const {return y();}
  double getZ() const {return z();}
  double getW() const {return w();}
  void setX(double v) {m_floats[0] = v;}
  void setY(double v) {m_floats[1] = v;}
  void setZ(double v) {m_floats[2] = v;}
  void setW(double v) {m_floats[3] = v;}
  double operator[](int i) const {return m_floats[i];}
  void setValue(double a, double b, double c, double d) {*this = Quaternion(a, b, c, d);}
  void setRotation(const Vector3 & axis, double angle)
  {
    const double s = std::sin(angle * 0.5) / axis.length();
    *this = Quaternion(axis.x() * s, axis.y() * s, axis.z() * s, std::cos(angle * 0.5));
  }
  void setRPY(double roll, double pitch, double yaw)
  {
    const double cr = std::cos(roll / 2), sr = std::sin(roll / 2), cp = std::cos(pitch / 2), sp = std::sin(pitch / 2);
    const double cy = std::cos(yaw / 2), sy = std::sin(yaw / 2);
    *this = Quaternion(
      sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy,
      cr * cp * cy + sr * sp * sy);
  }
  void setEuler(double yaw, double pitch, double roll) {setRPY(pitch, yaw, roll);}
  Quaternion operator*(const Quaternion & q) const
  {
    return {w() * q.x() + x() * q.w() + y() * q.z() - z() * q.y(), w() * q.y() - x() * q.z() + y() * q.w() + z() * q.x(),
      w() * q.z() + x() * q.y() - y() * q.x() + z() * q.w(), w() * q.w() - x() * q.x() - y() * q.y() - z() * q.z()};
  }
  Quaternion & operator*=(const Quaternion & q) {return *this = *this * q;}
  Quaternion operator*(double s) const {return {x() * s, y() * s, z() * s, w() * s};}
  Quaternion operator/(double s) const {return *this * (1.0 / s);}
  Quaternion operator+(const Quaternion & q) const {return {x() + q.x(), y() + q.y(), z() + q.z(), w() + q.w()};}
  Quaternion operator-(const Quaternion & q) const {return *this + q * -1.0;}
  Quaternion operator-() const {return *this * -1.0;}
  bool operator==(const Quaternion & q) const {return x() == q.x() && y() == q.y() && z() == q.z() && w() == q.w();}
  bool operator!=(const Quaternion & q) const {return !(*this == q);}
  double dot(const Quaternion & q) const {return x() * q.x() + y() * q.y() + z() * q.z() + w() * q.w();}
  double length2() const {return dot(*this);}
  double length() const {return std::sqrt(length2());}
  Quaternion & normalize() {return *this = *this / length();}
  Quaternion normalized() const {return *this / length();}
  Quaternion inverse() const {return {-x(), -y(), -z(), w()};}
  double getAngle() const {return 2.0 * std::acos(std::clamp(w(), -1.0, 1.0));}
  double getAngleShortestPath() const {return 2.0 * std::acos(std::clamp(std::abs(w()), -1.0, 1.0));}
  Vector3 getAxis() const
  {
    const double s = 1.0 - w() * w();
    return s < 10 * TF2SIMD_EPSILON ? Vector3(1, 0, 0) : Vector3(x(), y(), z()) / std::sqrt(s);
  }
  double angle(const Quaternion & q) const {return std::acos(dot(q) / std::sqrt(length2() * q.length2()));}
  double angleShortestPath(const Quaternion & q) const
  {
    return 2.0 * std::acos(std::clamp(std::abs(dot(q)) / std::sqrt(length2() * q.length2()), -1.0, 1.0));
  }
  Quaternion slerp(const Quaternion & given, double t) const
  {
    Quaternion q = given;
    double d = dot(q);
    if (d < 0) {
      q = -q;
      d = -d;
    }
    if (d > 1 - 1e-12) {
      return *this;
    }
    const double a = std::acos(std::min(1.0, d));
    return *this * (std::sin((1 - t) * a) / std::sin(a)) + q * (std::sin(t * a) / std::sin(a));
  }
};

inline Vector3 quatRotate(const Quaternion & q, const Vector3 & v)
{
  const Vector3 u(q.x(), q.y(), q.z());
  const Vector3 c = u.cross(v);
  return v + (c * q.w() + u.cross(c)) * 2.0;
}
inline Quaternion slerp(const Quaternion & a, const Quaternion & b, double t) {return a.slerp(b, t);}
inline double angle(const Quaternion & a, const Quaternion & b) {return a.angle(b);}
inline double angleShortestPath(const Quaternion & a, const Quaternion & b) {return a.angleShortestPath(b);}

class Matrix3x3
{
public:
  Matrix3x3() {setIdentity();}
  explicit Matrix3x3(const Quaternion & q) {setRotation(q);}
  Matrix3x3(
    double xx, double xy, double xz, double yx, double yy, double yz, double zx, double zy, double zz)
  : rows_{{xx, xy, xz}, {yx, yy, yz}, {zx, zy, zz}} {}
  static const Matrix3x3 & getIdentity()
  {
    static const Matrix3x3 identity;
    return identity;
  }
  void setIdentity() {*this = Matrix3x3(1, 0, 0, 0, 1, 0, 0, 0, 1);}
  void setValue(
    double xx, double xy, double xz, double yx, double yy, double yz, double zx, double zy, double zz)
  {
    *this = Matrix3x3(xx, xy, xz, yx, yy, yz, zx, zy, zz);
  }
  void setRotation(const Quaternion & q)
  {
    const double s = 2.0 / q.length2();
    const double xs = q.x() * s, ys = q.y() * s, zs = q.z() * s;
    const double wx = q.w() * xs, wy = q.w() * ys, wz = q.w() * zs;
    const double xx = q.x() * xs, xy = q.x() * ys, xz = q.x() * zs;
    const double yy = q.y() * ys, yz = q.y() * zs, zz = q.z() * zs;
    setValue(1 - (yy + zz), xy - wz, xz + wy, xy + wz, 1 - (xx + zz), yz - wx, xz - wy, yz + wx, 1 - (xx + yy));
  }
  void getRotation(Quaternion & q) const
  {
    const Matrix3x3 & m = *this;
    const double trace = m[0][0] + m[1][1] + m[2][2];
    if (trace > 0) {
      const double s = std::sqrt(trace + 1.0);
      q = Quaternion((m[2][1] - m[1][2]) / (2 * s), (m[0][2] - m[2][0]) / (2 * s), (m[1][0] - m[0][1]) / (2 * s), s / 2);
      return;
    }
    const int i = m[0][0] < m[1][1] ? (m[1][1] < m[2][2] ? 2 : 1) : (m[0][0] < m[2][2] ? 2 : 0);
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double s = std::sqrt(m[i][i] - m[j][j] - m[k][k] + 1.0);
    double out[3];
    out[i] = s * 0.5;
    out[j] = (m[j][i] + m[i][j]) * 0.5 / s;
    out[k] = (m[k][i] + m[i][k]) * 0.5 / s;
    q = Quaternion(out[0], out[1], out[2], (m[k][j] - m[j][k]) * 0.5 / s);
  }
  void setRPY(double roll, double pitch, double yaw)
  {
    Quaternion q;
    q.setRPY(roll, pitch, yaw);
    setRotation(q);
  }
  void setEulerYPR(double yaw, double pitch, double roll) {setRPY(roll, pitch, yaw);}
  void getEulerYPR(double & yaw, double & pitch, double & roll, unsigned solution = 1) const
  {
    const Matrix3x3 & m = *this;
    if (std::abs(m[2][0]) >= 1) {
      yaw = 0;
      const double delta = std::atan2(m[2][1], m[2][2]);
      pitch = m[2][0] < 0 ? TF2SIMD_PI / 2 : -TF2SIMD_PI / 2;
      roll = delta;
      return;
    }
    pitch = -std::asin(m[2][0]);
    if (solution != 1) {
      pitch = TF2SIMD_PI - pitch;
    }
    const double c = std::cos(pitch);
    roll = std::atan2(m[2][1] / c, m[2][2] / c);
    yaw = std::atan2(m[1][0] / c, m[0][0] / c);
  }
  void getEulerZYX(double & yaw, double & pitch, double & roll, unsigned solution = 1) const
  {
    getEulerYPR(yaw, pitch, roll, solution);
  }
  void getRPY(double & roll, double & pitch, double & yaw, unsigned solution = 1) const
  {
    getEulerYPR(yaw, pitch, roll, solution);
  }
  Vector3 & operator[](int i) {return rows_[i];}
  const Vector3 & operator[](int i) const {return rows_[i];}
  Vector3 & getRow(int i) {return rows_[i];}
  const Vector3 & getRow(int i) const {return rows_[i];}
  Vector3 getColumn(int i) const {return {rows_[0][i], rows_[1][i], rows_[2][i]};}
  Matrix3x3 transpose() const
  {
    const Matrix3x3 & m = *this;
    return {m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]};
  }
  double determinant() const {return rows_[0].dot(rows_[1].cross(rows_[2]));}
  Matrix3x3 inverse() const
  {
    const Vector3 a = rows_[1].cross(rows_[2]), b = rows_[2].cross(rows_[0]), c = rows_[0].cross(rows_[1]);
    const double d = 1.0 / determinant();
    return {a[0] * d, b[0] * d, c[0] * d, a[1] * d, b[1] * d, c[1] * d, a[2] * d, b[2] * d, c[2] * d};
  }
  Vector3 operator*(const Vector3 & v) const {return {rows_[0].dot(v), rows_[1].dot(v), rows_[2].dot(v)};}
  Matrix3x3 operator*(const Matrix3x3 & m) const
  {
    Matrix3x3 out;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        out[i][j] = rows_[i].dot(m.getColumn(j));
      }
    }
    return out;
  }
  Matrix3x3 & operator*=(const Matrix3x3 & m) {return *this = *this * m;}
  bool operator==(const Matrix3x3 & m) const {return rows_[0] == m[0] && rows_[1] == m[1] && rows_[2] == m[2];}

private:
  Vector3 rows_[3];
};

class Transform
{
public:
  Transform() = default;
  explicit Transform(const Quaternion & q, const Vector3 & origin = Vector3())
  : basis_(q), origin_(origin) {}
  explicit Transform(const Matrix3x3 & basis, const Vector3 & origin = Vector3())
  : basis_(basis), origin_(origin) {}
  static const Transform & getIdentity()
  {
    static const Transform identity;
    return identity;
  }
  Matrix3x3 & getBasis() {return basis_;}
  const Matrix3x3 & getBasis() const {return basis_;}
  Vector3 & getOrigin() {return origin_;}
  const Vector3 & getOrigin() const {return origin_;}
  Quaternion getRotation() const
  {
    Quaternion q;
    basis_.getRotation(q);
    return q;
  }
  void setOrigin(const Vector3 & origin) {origin_ = origin;}
  void setBasis(const Matrix3x3 & basis) {basis_ = basis;}
  void setRotation(const Quaternion & q) {basis_.setRotation(q);}
  void setIdentity() {*this = Transform();}
  Transform inverse() const
  {
    const Matrix3x3 back = basis_.transpose();
    return Transform(back, back * -origin_);
  }
  Transform inverseTimes(const Transform & t) const {return inverse() * t;}
  Vector3 operator()(const Vector3 & v) const {return basis_ * v + origin_;}
  Vector3 operator*(const Vector3 & v) const {return (*this)(v);}
  Quaternion operator*(const Quaternion & q) const {return getRotation() * q;}
  Transform operator*(const Transform & t) const {return Transform(basis_ * t.basis_, (*this)(t.origin_));}
  Transform & operator*=(const Transform & t) {return *this = *this * t;}
  void mult(const Transform & a, const Transform & b) {*this = a * b;}
  bool operator==(const Transform & t) const {return basis_ == t.basis_ && origin_ == t.origin_;}

private:
  Matrix3x3 basis_;
  Vector3 origin_;
};

}  // namespace tf2
