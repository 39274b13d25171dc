#include "cholesky.h"

namespace halfdisk {
namespace {

// A strip of rows times a block of columns takes some milliseconds for the largest matrix.
constexpr Eigen::Index kBlock = 64, kStrip = 32;

}  // namespace

Columns product(const SquareMatrix& A, const Columns& x, const StopQuestion& stop) {
    Columns result(A.size, x.cols());
    for (Eigen::Index i = 0; i < A.size; i += kStrip) {
        throwIfStopped(stop);
        const Eigen::Index rows = std::min(kStrip, A.size - i);
        result.middleRows(i, rows).noalias() = A.map().middleRows(i, rows) * x;
    }
    return result;
}

bool factorize(SquareMatrix& matrix, const StopQuestion& stop) {
    auto A = matrix.map();
    const Eigen::Index size = matrix.size;
    for (Eigen::Index k = 0; k < size; k += kBlock) {
        const Eigen::Index width = std::min(kBlock, size - k), below = k + width;
        auto corner = A.block(k, k, width, width);
        const Eigen::LLT<SquareMatrix::RowMajor> root(corner);
        if (root.info() != Eigen::Success) return false;
        corner = root.matrixL();
        for (Eigen::Index i = below; i < size; i += kStrip) {
            throwIfStopped(stop);
            auto strip = A.block(i, k, std::min(kStrip, size - i), width);
            corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(strip);
        }
        for (Eigen::Index i = below; i < size; i += kStrip) {
            throwIfStopped(stop);
            const Eigen::Index rows = std::min(kStrip, size - i), columns = i + rows - below;
            A.block(i, below, rows, columns).noalias() -=
                A.block(i, k, rows, width) * A.block(below, k, columns, width).transpose();
        }
    }
    return true;
}

void solve(const SquareMatrix& matrix, Columns& b, const StopQuestion& stop) {
    const auto L = matrix.map();
    for (Eigen::Index k = 0; k < matrix.size; k += kBlock) {
        throwIfStopped(stop);
        const Eigen::Index width = std::min(kBlock, matrix.size - k);
        auto part = b.middleRows(k, width);
        part.noalias() -= L.block(k, 0, width, k) * b.topRows(k);
        L.block(k, k, width, width).triangularView<Eigen::Lower>().solveInPlace(part);
    }
    for (Eigen::Index end = matrix.size; end > 0;) {
        throwIfStopped(stop);
        const Eigen::Index k = (end - 1) / kBlock * kBlock, width = end - k;
        auto part = b.middleRows(k, width);
        L.block(k, k, width, width).triangularView<Eigen::Lower>().transpose().solveInPlace(part);
        b.topRows(k).noalias() -= L.block(k, 0, width, k).transpose() * part;
        end = k;
    }
}

}  // namespace halfdisk
