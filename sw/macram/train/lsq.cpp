// Learned step size quantisation of maps, one pass over memory each way; formulas in macram.quant.lsq.
//
// Forward reads the values and writes them rounded to codes. Backward reads the values and the gradient, writes
// the values' gradient and sums up the step's.

#include "maps.hpp"

#include <numeric>

namespace {

// A run of elements, at most WIDE of them. Compilers make vectors of rounding in float32 alone, so values come
// here first.
struct Run {
    float q[WIDE], code[WIDE];
    Size n;

    template <class T> Run(const T *v, Size n, float step, float low, float high) : n(n) {
        for (Size j = 0; j < n; ++j) q[j] = float(v[j]) / step;
        // What is no number stays none: it is neither below nor above.
        for (Size j = 0; j < n; ++j) code[j] = q[j] < low ? low : q[j] > high ? high : q[j];
        for (Size j = 0; j < n; ++j) code[j] = std::nearbyint(code[j]);  // half to even
    }
};

template <class T>
void quantise(const Shape &shape, const T *v, T *y, float step, float low, float high) {
    shape.each([=](Size i, Size n) {
        const Run run(v + i, n, step, low, high);
        for (Size j = 0; j < n; ++j) y[i + j] = run.code[j] * step;
    });
}

template <class T>
double gradients(const Shape &shape, const T *v, const T *grad, T *to_v, float step, float low, float high) {
    std::vector<double> sums(shape.pieces());
#pragma omp parallel for num_threads(shape.threads) schedule(static)
    for (Size piece = 0; piece < shape.pieces(); ++piece) {
        const Size end = shape.start(piece + 1);
        for (Size i = shape.start(piece); i < end; i += shape.period) {
            const Run run(v + i, std::min(shape.period, end - i), step, low, high);
            float sum = 0;
#pragma omp simd reduction(+ : sum)
            for (Size j = 0; j < run.n; ++j) {
                const float q = run.q[j], all = grad[i + j];
                const bool inside = q > low && q < high;
                to_v[i + j] = (inside ? 1.0f : 0.0f) * all;
                // Outside, codes are the bounds, and so is the slope.
                sum += all * (run.code[j] - (inside ? q : 0.0f));
            }
            sums[piece] += sum;
        }
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

#define EXPORTED(NAME, T)                                                                                    \
    extern "C" void quantise_##NAME(Size count, Size threads, const T *v, T *y, const float *step,           \
                                    double low, double high) {                                               \
        quantise(Shape(count, 1, threads), v, y, *step, low, high);                                          \
    }                                                                                                        \
    extern "C" void gradients_##NAME(Size count, Size threads, const T *v, const T *grad, T *to_v,           \
                                     float *to_step, const float *step, double low, double high) {           \
        *to_step = float(gradients(Shape(count, 1, threads), v, grad, to_v, *step, low, high));              \
    }

EXPORTED(bfloat16, Bf16)
EXPORTED(float32, float)
