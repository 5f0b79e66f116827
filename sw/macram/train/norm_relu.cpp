// Batch normalisation and ReLU of maps with channels innermost, in as few passes over memory as possible.
//
// A map may be added to the result, as residual units do. Forward reads x twice and writes y once; backward
// reads x and the gradient twice and writes once. ReLU's mask is computed anew from x, so that y need not be
// kept. Formulas: Ioffe and Szegedy, "Batch Normalization" (2015), section 3.
//
// A map of few channels is taken as one of several times as many: the vectors are full whatever the channels.
// Sums are made over pieces whose bounds depend on the shape alone, so results do not depend on the threads.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace {

using Size = std::int64_t;

constexpr Size WIDE = 256;    // elements taken as one pixel, about
constexpr Size PIECES = 64;   // of a map at most, each summed by itself
constexpr Size PIECE = 1 << 14;  // elements of a piece at least
constexpr Size STRIP = 256;   // pixels summed in float32 before they are added in float64

struct Bf16 {
    std::uint16_t bits;
    operator float() const {
        const std::uint32_t wide = std::uint32_t(bits) << 16;
        float value;
        std::memcpy(&value, &wide, sizeof value);
        return value;
    }
    void operator=(float value) {  // to the nearest, ties to even
        std::uint32_t wide;
        std::memcpy(&wide, &value, sizeof wide);
        bits = std::uint16_t((wide + 0x7fff + ((wide >> 16) & 1)) >> 16);
    }
};

struct Shape {
    Size count, channels, period;
    int threads;

    Shape(Size rows, Size channels, int threads)
        : count(rows * channels), channels(channels),
          period(channels * std::max(Size(1), WIDE / channels)), threads(threads) {}

    Size groups() const { return (count + period - 1) / period; }
    Size pieces() const { return std::clamp(count / PIECE, Size(1), PIECES); }
    Size start(Size piece) const { return std::min(count, groups() * piece / pieces() * period); }

    // A value per channel, repeated over the period.
    template <class Value> std::vector<float> spread(Value value) const {
        std::vector<float> all(period);
        for (Size j = 0; j < period; ++j) all[j] = float(value(j % channels));
        return all;
    }

    // Calls `work(i, n)` for runs of n <= period elements from i on; i is a multiple of the period.
    template <class Work> void each(Work work) const {
#pragma omp parallel for num_threads(threads) schedule(static)
        for (Size piece = 0; piece < pieces(); ++piece) {
            const Size end = start(piece + 1);
            for (Size i = start(piece); i < end; i += period) work(i, std::min(period, end - i));
        }
    }

    // Sums over the pixels of both values of `term(i, j)`, element i of channel j % channels: `channels` sums
    // of the first, then of the second.
    template <class Term> std::vector<double> sums(Term term) const {
        std::vector<double> parts(pieces() * 2 * period);
#pragma omp parallel for num_threads(threads) schedule(static)
        for (Size piece = 0; piece < pieces(); ++piece) {
            std::vector<float> both(2 * period);
            float *const first = both.data(), *const second = first + period;
            double *const part = parts.data() + piece * 2 * period;
            const Size end = start(piece + 1);
            for (Size i = start(piece); i < end;) {
                std::fill(both.begin(), both.end(), 0.0f);
                const Size stop = std::min(end, i + STRIP * period);
                for (; i + 4 * period <= stop; i += 4 * period) {
#pragma omp simd
                    for (Size j = 0; j < period; ++j) {
                        const auto a = term(i + j, j), b = term(i + j + period, j);
                        const auto c = term(i + j + 2 * period, j), d = term(i + j + 3 * period, j);
                        first[j] += (a.first + b.first) + (c.first + d.first);
                        second[j] += (a.second + b.second) + (c.second + d.second);
                    }
                }
                for (; i < stop; i += period) {
                    const Size n = std::min(period, stop - i);
                    for (Size j = 0; j < n; ++j) {
                        const auto a = term(i + j, j);
                        first[j] += a.first;
                        second[j] += a.second;
                    }
                }
                for (Size j = 0; j < 2 * period; ++j) part[j] += both[j];
            }
        }
        std::vector<double> all(2 * channels);
        for (Size piece = 0; piece < pieces(); ++piece)
            for (Size j = 0; j < 2 * period; j += channels)
                for (Size c = 0; c < channels; ++c)
                    all[(j < period ? 0 : channels) + c] += parts[piece * 2 * period + j + c];
        return all;
    }
};

struct Two {
    float first, second;
};

// What comes before ReLU: slope * (x - centre) + offset, the same in both directions, and so is the mask.
struct Affine {
    std::vector<float> slope, centre, offset;

    Affine(const Shape &shape, const float *weight, const float *bias, const float *mean,
           const float *variance, double eps)
        : slope(shape.spread([=](Size c) { return weight[c] / std::sqrt(variance[c] + eps); })),
          centre(shape.spread([=](Size c) { return mean[c]; })),
          offset(shape.spread([=](Size c) { return bias[c]; })) {}
};

template <class T>
void forward(const Shape &shape, const T *x, const T *plus, T *y, const float *weight, const float *bias,
             double eps, float *mean, float *variance) {
    const double rows = double(shape.count / shape.channels);
    // Distances from the first pixel: squares of a mean much larger than the deviation would leave no digits.
    const std::vector<float> origin = shape.spread([=](Size c) { return float(x[c]); });
    const float *const from = origin.data();
    const std::vector<double> sums = shape.sums([=](Size i, Size j) {
        const float away = float(x[i]) - from[j];
        return Two{away, away * away};
    });
    for (Size c = 0; c < shape.channels; ++c) {
        const double away = sums[c] / rows;
        mean[c] = float(from[c] + away);
        const double spread = sums[shape.channels + c] / rows - away * away;
        variance[c] = float(spread < 0 ? 0 : spread);  // so that no number stays none
    }
    const Affine affine(shape, weight, bias, mean, variance, eps);
    const float *const slope = affine.slope.data(), *const centre = affine.centre.data();
    const float *const offset = affine.offset.data();
    const auto positive = [=](Size i, Size j) {
        const float value = slope[j] * (float(x[i + j]) - centre[j]) + offset[j];
        return value < 0 ? 0 : value;
    };
    shape.each([=](Size i, Size n) {
        if (plus != nullptr) {
#pragma omp simd
            for (Size j = 0; j < n; ++j) y[i + j] = positive(i, j) + float(plus[i + j]);
        } else {
#pragma omp simd
            for (Size j = 0; j < n; ++j) y[i + j] = positive(i, j);
        }
    });
}

template <class T>
void backward(const Shape &shape, const T *grad, const T *x, T *to_x, const float *weight, const float *bias,
              const float *mean, const float *variance, double eps, float *to_weight, float *to_bias) {
    const double rows = double(shape.count / shape.channels);
    const Affine affine(shape, weight, bias, mean, variance, eps);
    const float *const slope = affine.slope.data(), *const centre = affine.centre.data();
    const float *const offset = affine.offset.data();
    const std::vector<double> sums = shape.sums([=](Size i, Size j) {
        const float away = float(x[i]) - centre[j], all = grad[i];
        const float passed = slope[j] * away + offset[j] <= 0 ? 0 : all;
        return Two{passed, passed * away};
    });
    std::vector<double> along(shape.channels), rest(shape.channels);
    for (Size c = 0; c < shape.channels; ++c) {
        const double inverse = 1 / std::sqrt(variance[c] + eps);
        to_bias[c] = float(sums[c]);
        to_weight[c] = float(sums[shape.channels + c] * inverse);
        along[c] = -weight[c] * inverse * inverse * inverse * sums[shape.channels + c] / rows;
        rest[c] = -weight[c] * inverse * sums[c] / rows;
    }
    const std::vector<float> alongs = shape.spread([&](Size c) { return along[c]; });
    const std::vector<float> rests = shape.spread([&](Size c) { return rest[c]; });
    const float *const by_x = alongs.data(), *const constant = rests.data();
    shape.each([=](Size i, Size n) {
#pragma omp simd
        for (Size j = 0; j < n; ++j) {
            const float away = float(x[i + j]) - centre[j], all = grad[i + j];
            const float passed = slope[j] * away + offset[j] <= 0 ? 0 : all;
            to_x[i + j] = slope[j] * passed + (by_x[j] * away + constant[j]);
        }
    });
}

}  // namespace

#define EXPORTED(NAME, T)                                                                                    \
    extern "C" void forward_##NAME(Size rows, Size channels, int threads, const T *x, const T *plus, T *y,   \
                                   const float *weight, const float *bias, double eps, float *mean,          \
                                   float *variance) {                                                        \
        forward(Shape(rows, channels, threads), x, plus, y, weight, bias, eps, mean, variance);              \
    }                                                                                                        \
    extern "C" void backward_##NAME(Size rows, Size channels, int threads, const T *grad, const T *x, T *to_x,\
                                    const float *weight, const float *bias, const float *mean,               \
                                    const float *variance, double eps, float *to_weight, float *to_bias) {   \
        backward(Shape(rows, channels, threads), grad, x, to_x, weight, bias, mean, variance, eps,           \
                 to_weight, to_bias);                                                                        \
    }

EXPORTED(bfloat16, Bf16)
EXPORTED(float32, float)
