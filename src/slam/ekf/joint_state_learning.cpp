// SPDX-License-Identifier: GPL-3.0-or-later
// How EKF-SLAM's Gaussian learns, and what is at hand of it.

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "joint_state.hpp"

namespace hitos {
namespace {

/// What a reading has of one of its columns: the strip in a panel, and H's two numbers.
struct Share {
    const double* strip;
    double first;
    double second;
};

/// Two columns of W = P H' in one panel.
HITOS_INLINE void combine(double* to, Share a, Share b, Share c, Share d, Share e) {
    double* const second = to + Strip::kRows;
    HITOS_LANES
    for (std::size_t i = 0; i < Strip::kRows; ++i) {
        to[i] = a.strip[i] * a.first + b.strip[i] * b.first + c.strip[i] * c.first +
                d.strip[i] * d.first + e.strip[i] * e.first;
        second[i] = a.strip[i] * a.second + b.strip[i] * b.second + c.strip[i] * c.second +
                    d.strip[i] * d.second + e.strip[i] * e.second;
    }
}

/// Four columns of W L'^-1 but for what the columns before take from them: x = (w - x l) / l_kk,
/// the columns of l being those of L'.
HITOS_INLINE void divide_four(double* x, const double* l, std::size_t stride,
                              const double* inverse) {
    double* const x1 = x + Strip::kRows;
    double* const x2 = x1 + Strip::kRows;
    double* const x3 = x2 + Strip::kRows;
    const double* const l1 = l + stride;
    const double* const l2 = l1 + stride;
    const double l01 = l[1];
    const double l02 = l[2];
    const double l03 = l[3];
    const double l12 = l1[2];
    const double l13 = l1[3];
    const double l23 = l2[3];
    const double i0 = inverse[0];
    const double i1 = inverse[1];
    const double i2 = inverse[2];
    const double i3 = inverse[3];
    HITOS_LANES
    for (std::size_t i = 0; i < Strip::kRows; ++i) {
        const double y0 = x[i] * i0;
        const double y1 = (x1[i] - y0 * l01) * i1;
        const double y2 = ((x2[i] - y0 * l02) - y1 * l12) * i2;
        const double y3 = (((x3[i] - y0 * l03) - y1 * l13) - y2 * l23) * i3;
        x[i] = y0;
        x1[i] = y1;
        x2[i] = y2;
        x3[i] = y3;
    }
}

HITOS_INLINE void divide(double* x, const double* l, std::size_t terms, const double* inverse) {
    for (std::size_t k = 0; k < terms; k += 4) {
        subtract_products(x + k * Strip::kRows, 4, x, l + k, terms, k);
        divide_four(x + k * Strip::kRows, l + k * terms + k, terms, inverse + k);
    }
}

/// mean += U y and P -= U U' where P's own blocks are kept.
HITOS_INLINE void learn_own(double* mean, double* own, const double* u, const double* y,
                            std::size_t terms) {
    double* const next = own + Strip::kRows;
    for (std::size_t k = 0; k < terms; ++k) {
        const double* const column = u + k * Strip::kRows;
        const double by = y[k];
        HITOS_LANES
        for (std::size_t i = 0; i < Strip::kRows; ++i) {
            mean[i] += column[i] * by;
            own[i] -= column[i] * column[i];
        }
        HITOS_LANES
        for (std::size_t i = 0; i + 1 < Strip::kRows; ++i) next[i] -= column[i] * column[i + 1];
    }
}

/// The triangle T with T T' = Z Z' + G G', by the reflections that take G's columns into Z's, one
/// for each row; G is of no use afterwards.
void absorb(TallMatrix& z, TallMatrix& g, std::size_t rows, std::size_t terms) {
    constexpr double kNothing = 1e-290;  // squares below are next to no numbers
    std::vector<double> v(terms);
    for (std::size_t row = 0; row < rows; ++row) {
        double rest = 0.0;
        for (std::size_t k = 0; k < terms; ++k) {
            v[k] = g(row, k);
            rest += v[k] * v[k];
        }
        if (rest < kNothing) continue;
        const double before = z(row, row);
        const double after = std::sqrt(before * before + rest);
        const double v0 = before + std::copysign(after, before);
        const double by = 2.0 / (v0 * v0 + rest);
        vectorised([&]() HITOS_INLINED {
            for (std::size_t p = row / Strip::kRows; p * Strip::kRows < rows; ++p) {
                double* const column = z.panel(p) + row * Strip::kRows;
                double* const strips = g.panel(p);
                alignas(64) double along[Strip::kRows];  // NOLINT(*-avoid-c-arrays): registers
                HITOS_LANES
                for (std::size_t i = 0; i < Strip::kRows; ++i) along[i] = column[i] * v0;
                for (std::size_t k = 0; k < terms; ++k) {
                    const double* const strip = strips + k * Strip::kRows;
                    const double vk = v[k];
                    HITOS_LANES
                    for (std::size_t i = 0; i < Strip::kRows; ++i) along[i] += strip[i] * vk;
                }
                HITOS_LANES
                for (std::size_t i = 0; i < Strip::kRows; ++i) {
                    along[i] *= by;
                    column[i] -= along[i] * v0;
                }
                for (std::size_t k = 0; k < terms; ++k) {
                    double* const strip = strips + k * Strip::kRows;
                    const double vk = v[k];
                    HITOS_LANES
                    for (std::size_t i = 0; i < Strip::kRows; ++i) strip[i] -= along[i] * vk;
                }
            }
        });
        for (std::size_t k = 0; k < terms; ++k) g(row, k) = 0.0;
    }
}

}  // namespace

void JointState::update(std::span<const Row> rows) {
    if (rows.empty()) return;
    std::vector<Eigen::Index> places;
    for (const Row& row : rows) places.push_back(row.at);
    attend(std::move(places));
    std::vector<Reading> readings;
    for (const Row& row : rows) {
        const std::size_t column = column_of(row.at);
        Reading reading{{0, 1, 2, column, column + 1}, {}, row.nu, row.r};
        reading.by << row.by_pose, row.by_landmark;
        readings.push_back(reading);
    }
    learn(readings);
}

void JointState::join(Eigen::Index first, Eigen::Index second, const Vector2& nu, double sign,
                      const Matrix2& r) {
    attend({first, second});
    const std::size_t a = column_of(first);
    const std::size_t b = column_of(second);
    Reading reading{{a, a + 1, b, b + 1, kFirst - 1}, {}, -nu, r};
    reading.by << 1.0, 0.0, -sign, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0;
    learn(std::span(&reading, 1));
}

void JointState::learn(std::span<const Reading> readings) {
    const std::size_t count = 2 * readings.size();
    const std::size_t terms = whole_terms(count);
    const auto combine_all = [&](TallMatrix& to, const TallMatrix& from) {
        vectorised([&]() HITOS_INLINED {
            for (std::size_t p = 0; p < from.panels(); ++p) {
                const double* const panel = from.panel(p);
                double* const out = to.panel(p);
                for (std::size_t k = 0; k < readings.size(); ++k) {
                    const Reading& reading = readings[k];
                    const auto share = [&](std::size_t place) HITOS_INLINED {
                        const auto at = static_cast<Eigen::Index>(place);
                        return Share{panel + reading.columns[place] * Strip::kRows,
                                     reading.by(0, at), reading.by(1, at)};
                    };
                    combine(out + 2 * k * Strip::kRows, share(0), share(1), share(2), share(3),
                            share(4));
                }
                std::fill(out + count * Strip::kRows, out + terms * Strip::kRows, 0.0);
            }
        });
    };
    w_.reshape(hand_.panels(), terms);
    combine_all(w_, hand_);

    const auto size = static_cast<Eigen::Index>(count);
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd nu(size);
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const Reading& reading = readings[k];
        const auto at = static_cast<Eigen::Index>(2 * k);
        for (std::size_t c = 0; c < Reading::kColumns; ++c) {
            const std::size_t row = row_of_column(reading.columns[c]);
            const Vector2 by = reading.by.col(static_cast<Eigen::Index>(c));
            for (Eigen::Index j = 0; j < size; ++j) {
                s.block<2, 1>(at, j) += by * w_(row, static_cast<std::size_t>(j));
            }
        }
        s.block<2, 2>(at, at) += reading.r;
        nu.segment<2>(at) = reading.nu;
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(s);
    if (factor.info() != Eigen::Success) return;

    // L', its inverse diagonal and L^-1 nu, filled up to whole terms.
    by_.assign(terms * terms, 0.0);
    factors_.assign(2 * terms, 0.0);
    double* const inverse = factors_.data();
    double* const y = inverse + terms;
    const Eigen::VectorXd solved = factor.matrixL().solve(nu);
    for (std::size_t k = 0; k < terms; ++k) inverse[k] = 1.0;
    for (std::size_t k = 0; k < count; ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        for (std::size_t j = 0; j < k; ++j) {
            by_[j * terms + k] = factor.matrixLLT()(at, static_cast<Eigen::Index>(j));
        }
        inverse[k] = 1.0 / factor.matrixLLT()(at, at);
        y[k] = solved(at);
    }
    vectorised([&]() HITOS_INLINED {
        for (std::size_t p = 0; p < w_.panels(); ++p) {
            divide(w_.panel(p), by_.data(), terms, inverse);
            learn_own(mean_.data() + p * Strip::kRows, own_.panel(p), w_.panel(p), y, terms);
        }
    });
    if (lags()) {
        w_now_.reshape(now_.panels(), terms);
        combine_all(w_now_, now_);
        vectorised([&]() HITOS_INLINED {
            for (std::size_t p = 0; p < now_.panels(); ++p) {
                divide(w_now_.panel(p), by_.data(), terms, inverse);
            }
        });
    }

    const std::size_t columns = this->columns();
    by_.resize(terms * columns);
    for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t row = row_of_column(c);
        for (std::size_t k = 0; k < terms; ++k) by_[k * columns + c] = w_(row, k);
    }
    const auto learn_columns = [&](TallMatrix& at_hand, const TallMatrix& u) {
        vectorised([&]() HITOS_INLINED {
            for (std::size_t p = 0; p < at_hand.panels(); ++p) {
                subtract_products(at_hand.panel(p), columns, u.panel(p), by_.data(), columns,
                                  terms);
            }
        });
    };
    learn_columns(hand_, w_);
    if (!lags()) return;
    learn_columns(now_, w_now_);
    absorb(gained_, w_now_, first_columns_, terms);
    lagging_ = true;
}

void JointState::attend(std::vector<Eigen::Index> places) {
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const auto missing = static_cast<std::size_t>(
        std::ranges::count_if(places, [&](Eigen::Index at) { return column_of(at) == 0; }));
    make_room(2 * missing, 2 * places.size());
    for (const Eigen::Index at : places) {
        if (column_of(at) == 0) attend_to(at);
    }
}

void JointState::attend_to(Eigen::Index at) {
    const std::size_t row = row_of(at);
    const std::size_t column = columns();
    const std::size_t place = first_columns_;
    for (std::size_t k = 0; k < 2; ++k) {
        settled_.read_column(row + k, first_, place + k);
        for (std::size_t p = 0; p < hand_.panels(); ++p) {
            std::copy_n(first_.panel(p) + (place + k) * Strip::kRows, Strip::kRows,
                        hand_.panel(p) + (column + k) * Strip::kRows);
        }
        for (std::size_t p = 0; p < now_.panels(); ++p) {
            std::fill_n(now_.panel(p) + (column + k) * Strip::kRows, Strip::kRows, 0.0);
        }
    }
    if (lagging_) {
        // P = P0 - C Z (C_row Z)', of both rows.
        Eigen::MatrixXd z(static_cast<Eigen::Index>(place), static_cast<Eigen::Index>(place));
        for (std::size_t i = 0; i < place; ++i) {
            for (std::size_t j = 0; j < place; ++j) {
                z(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = gained_(i, j);
            }
        }
        const std::size_t terms = whole_terms(place);
        by_.assign(2 * terms, 0.0);
        for (std::size_t k = 0; k < 2; ++k) {
            const Eigen::VectorXd back = z.triangularView<Eigen::Lower>() * gained_of(row + k);
            for (std::size_t i = 0; i < place; ++i) {
                by_[2 * i + k] = back(static_cast<Eigen::Index>(i));
                now_(i, column + k) = -by_[2 * i + k];
            }
        }
        vectorised([&]() HITOS_INLINED {
            for (std::size_t p = 0; p < hand_.panels(); ++p) {
                subtract_products(hand_.panel(p) + column * Strip::kRows, 2, first_.panel(p),
                                  by_.data(), 2, terms);
            }
        });
    }
    now_(place, column) = now_(place + 1, column + 1) = 1.0;
    first_columns_ += 2;
    take_column(row);
    const double across = own_(row, 1);
    hand_(row, column) = own_(row, 0);
    hand_(row + 1, column) = hand_(row, column + 1) = across;
    hand_(row + 1, column + 1) = own_(row + 1, 0);
    // What is at hand of others is up to date.
    for (std::size_t other = 0; other < column; ++other) {
        for (std::size_t k = 0; k < 2; ++k) {
            hand_(row_of_column(other), column + k) = hand_(row + k, other);
        }
    }
}

Eigen::VectorXd JointState::gained_of(std::size_t row) const {
    Eigen::VectorXd gained = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(first_columns_));
    for (std::size_t j = 0; j < first_columns_; ++j) {
        double sum = 0.0;
        for (std::size_t i = j; i < first_columns_; ++i) sum += first_(row, i) * gained_(i, j);
        gained(static_cast<Eigen::Index>(j)) = sum;
    }
    return gained;
}

void JointState::take_column(std::size_t row) {
    column_of_[(row - kFirst) / 2] = columns();
    attended_.push_back(row);
}

std::size_t JointState::row_of_column(std::size_t column) const {
    return column < kFirst ? column : attended_[(column - kFirst) / 2] + column % 2;
}

}  // namespace hitos
