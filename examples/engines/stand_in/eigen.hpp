// SPDX-License-Identifier: MIT
#pragma once

// Eigen where it is installed, else what the recipe takes from it, by the names of its documentation.

#if __has_include(<Eigen/Core>)
#include <Eigen/Core>
#elif __has_include(<eigen3/Eigen/Core>)
#include <eigen3/Eigen/Core>
#else
#include <cstddef>
#include <vector>

namespace Eigen {

inline constexpr int Dynamic = -1;
enum StorageOptions { ColMajor = 0, RowMajor = 1 };

template <class T, int Rows, int Columns, int Options = ColMajor>
class Matrix {
public:
    using Scalar = T;
    using Index = std::ptrdiff_t;
    static constexpr int RowsAtCompileTime = Rows, ColsAtCompileTime = Columns;
    static constexpr bool IsRowMajor = (Options & RowMajor) != 0;

    void resize(Index rows, Index columns)
    {
        rows_ = rows, columns_ = columns;
        held_.resize(static_cast<std::size_t>(rows * columns));
    }
    Index rows() const { return rows_; }
    Index cols() const { return columns_; }
    T* data() { return held_.data(); }
    T& operator()(Index row, Index column)
    {
        return held_[static_cast<std::size_t>(IsRowMajor ? row * columns_ + column : column * rows_ + row)];
    }

private:
    Index rows_ = 0, columns_ = 0;
    std::vector<T> held_;
};
using Matrix3Xf = Matrix<float, 3, Dynamic>;
using Matrix3Xi = Matrix<int, 3, Dynamic>;

}  // namespace Eigen
#endif
