// How are thousands of symmetric equations solved so that the work can be called off within milliseconds? In
// blocks, with a question between them.
//
// Cholesky's factorization A = L L^T, right-looking and blocked (Golub & Van Loan 2013, "Matrix
// Computations", section 4.2.9); Eigen does each block.
#pragma once

#include <Eigen/Dense>
#include <memory>

#include "stop.h"

namespace halfdisk {

using Column = Eigen::VectorXd;
using Columns = Eigen::MatrixXd;

/// Memory that nobody has touched yet, row by row: zeroing it all at once may take too long.
struct SquareMatrix {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    Eigen::Index size = 0;
    std::unique_ptr<double[]> rows;

    Eigen::Map<RowMajor> map() { return {rows.get(), size, size}; }
    Eigen::Map<const RowMajor> map() const { return {rows.get(), size, size}; }
};

/// A x. These throw Stopped if `stop` says so.
Columns product(const SquareMatrix& A, const Columns& x, const StopQuestion& stop);

/// Puts L in the place of A's lower triangle; what lies above it is not used. False if A is not positive
/// definite.
bool factorize(SquareMatrix& A, const StopQuestion& stop);

/// Puts the solution of L L^T x = b in the place of b.
void solve(const SquareMatrix& L, Columns& b, const StopQuestion& stop);

}  // namespace halfdisk
