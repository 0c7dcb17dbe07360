#include "ellipse/covariance_ellipse.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <concepts>
#include <fmt/format.h>

namespace ellipse {
namespace {

template <std::floating_point T>
T axis(T eigenvalue) {
    // Rounding can make the eigenvalue of a singular matrix slightly negative.
    return std::sqrt(std::max(eigenvalue, T{0}));
}

}  // namespace

void CovarianceEllipse::Axes(double sxx, double sxy, double syy, double& longer, double& shorter) {
    if (sxx < 0 || syy < 0 || sxx * syy < sxy * sxy) {
        throw InvalidCovariance(
            fmt::format("[[{0:.{3}g}, {1:.{3}g}], [{1:.{3}g}, {2:.{3}g}]] is no covariance", sxx, sxy, syy, ELLIPSE_DIGITS));
    }
    const Eigen::Matrix2d covariance{{sxx, sxy}, {sxy, syy}};
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance, Eigen::EigenvaluesOnly);
    longer = axis(solver.eigenvalues()[1]);
    shorter = axis(solver.eigenvalues()[0]);
}

}  // namespace ellipse
