// Batch normalisation and ReLU of maps with channels innermost, in as few passes over memory as possible.
//
// A map may be added to the result, as residual units do. Forward reads x twice and writes y once; backward
// reads x and the gradient twice and writes once. ReLU's mask is computed anew from x, so that y need not be
// kept. `apply` takes given statistics and reads x once. Formulas: Ioffe and Szegedy, "Batch Normalization"
// (2015), section 3.

#include "maps.hpp"

namespace {

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
void apply(const Shape &shape, const T *x, const T *plus, T *y, const float *weight, const float *bias,
           const float *mean, const float *variance, double eps) {
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
    apply(shape, x, plus, y, weight, bias, mean, variance, eps);
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
    extern "C" void forward_##NAME(Size rows, Size channels, Size threads, const T *x, const T *plus, T *y,  \
                                   const float *weight, const float *bias, double eps, float *mean,          \
                                   float *variance) {                                                        \
        forward(Shape(rows, channels, threads), x, plus, y, weight, bias, eps, mean, variance);              \
    }                                                                                                        \
    extern "C" void apply_##NAME(Size rows, Size channels, Size threads, const T *x, const T *plus, T *y,    \
                                 const float *weight, const float *bias, const float *mean,                  \
                                 const float *variance, double eps) {                                        \
        apply(Shape(rows, channels, threads), x, plus, y, weight, bias, mean, variance, eps);                \
    }                                                                                                        \
    extern "C" void backward_##NAME(Size rows, Size channels, Size threads, const T *grad, const T *x,       \
                                    T *to_x, const float *weight, const float *bias, const float *mean,      \
                                    const float *variance, double eps, float *to_weight, float *to_bias) {   \
        backward(Shape(rows, channels, threads), grad, x, to_x, weight, bias, mean, variance, eps,           \
                 to_weight, to_bias);                                                                        \
    }

EXPORTED(bfloat16, Bf16)
EXPORTED(float32, float)
