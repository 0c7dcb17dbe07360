#pragma once

#include <stdexcept>

namespace ellipse {

/// The matrix has a negative eigenvalue.
struct InvalidCovariance : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

class CovarianceEllipse {
public:
    /// Square roots of the eigenvalues of [[sxx, sxy], [sxy, syy]]; in m for variances in m².
    void Axes(double sxx, double sxy, double syy, double& longer, double& shorter);
};

}  // namespace ellipse
