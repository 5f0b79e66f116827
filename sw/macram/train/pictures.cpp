// Views of packed frames in one pass: sampled, toned, given noise, rounded to whole grey levels, normalised.
//
// A row of a view stays in the cache from the first step to the last. Neither a grid of positions nor a frame
// in floating point is ever written to memory.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace {

using Size = std::int64_t;

constexpr int COLOURS = 3, BYTES = 4;  // of a packed pixel: red, green, blue, mask
constexpr float TINY = 1e-9f;          // of a grey level between 0 and 1: its powers are black too

// Logarithm of a positive number to base 2, to about 1e-7 of the number.
inline float log2_of(float x) {
    std::int32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;  // the mantissa is between sqrt(1/2) and sqrt(2)
    bits -= exponent << 23;
    float mantissa;
    std::memcpy(&mantissa, &bits, sizeof mantissa);
    const float t = (mantissa - 1) / (mantissa + 1), s = t * t;  // ln(m) = 2 atanh(t)
    const float series = 1 + s * (1 / 3.0f + s * (1 / 5.0f + s * (1 / 7.0f)));
    return float(exponent) + 2.88539008f * t * series;  // 2 / ln(2)
}

// 2 to the power x, -126 < x < 128.
inline float exp2_of(float x) {
    const float whole = std::rint(x), u = (x - whole) * 0.693147181f;
    const float end = 1 / 24.0f + u * (1 / 120.0f + u / 720);
    const float series = 1 + u * (1 + u * (1 / 2.0f + u * (1 / 6.0f + u * end)));
    const std::int32_t bits = (std::int32_t(whole) + 127) << 23;
    float scale;
    std::memcpy(&scale, &bits, sizeof scale);
    return scale * series;
}

struct Frame {
    const std::uint8_t *pixels;
    int height, width;

    // A row of a view: `to[c * n + k]` is colour c at (sx + k * dx, sy + k * dy), in pixels from the first
    // one's centre; bilinear, as if the frame lay on an endless plane of grey level `border`.
    void sample(float *to, int n, float sx, float sy, float dx, float dy, float border) const {
#pragma omp simd
        for (int k = 0; k < n; ++k) {
            const float x = sx + float(k) * dx, y = sy + float(k) * dy;
            const float left = std::floor(x), top = std::floor(y);
            const float right_part = x - left, bottom_part = y - top;
            const int x0 = int(left), y0 = int(top);
            float sum[COLOURS] = {0, 0, 0};
            for (int corner = 0; corner < 4; ++corner) {
                const int i = x0 + (corner & 1), j = y0 + (corner >> 1);
                const bool outside = (i < 0) | (i >= width) | (j < 0) | (j >= height);
                const int at = std::clamp(j, 0, height - 1) * width + std::clamp(i, 0, width - 1);
                const float across = corner & 1 ? right_part : 1 - right_part;
                const float down = corner >> 1 ? bottom_part : 1 - bottom_part;
                const float weight = outside ? 0 : across * down;
                std::uint32_t pixel;
                std::memcpy(&pixel, pixels + BYTES * at, BYTES);
                for (int c = 0; c < COLOURS; ++c)
                    sum[c] += weight * (float(std::int32_t(pixel >> 8 * c & 255)) - border);
            }
            for (int c = 0; c < COLOURS; ++c) to[c * n + k] = sum[c] + border;
        }
    }
};

}  // namespace

// Writes float32 views [count, rows, columns, 3]. Of view b: `place` + 6 b maps its pixel centres to frame
// pixels; `tone` + 3 b is gamma, gain and noise level; its noise, a value per colour, row and column, starts
// at bank[noise[b]].
extern "C" void pictures(Size count, Size rows, Size columns, Size threads, const std::uint8_t *frames,
                         const Size *frame, Size height, Size width, const float *place, const float *tone,
                         const float *bank, const Size *noise, double border, const float *mean,
                         const float *deviation, float *result) {
    const int n = int(columns);
#pragma omp parallel num_threads(threads)
    {
        std::vector<float> line(COLOURS * columns);
#pragma omp for collapse(2) schedule(static)
        for (Size b = 0; b < count; ++b) {
            for (Size row = 0; row < rows; ++row) {
                const Frame source{frames + frame[b] * height * width * BYTES, int(height), int(width)};
                const float *const m = place + 6 * b;
                const float down = float(row) + 0.5f;
                source.sample(line.data(), n, m[0] * 0.5f + m[1] * down + m[2] - 0.5f,
                              m[3] * 0.5f + m[4] * down + m[5] - 0.5f, m[0], m[3], border);
                const float gamma = tone[3 * b], gain = 255 * tone[3 * b + 1], level = tone[3 * b + 2];
                float *const to = result + (b * rows + row) * columns * COLOURS;
                for (int c = 0; c < COLOURS; ++c) {
                    float *const colour = line.data() + c * columns;
                    const float *const grain = bank + noise[b] + (c * rows + row) * columns;
                    if (gamma != 1) {
#pragma omp simd
                        for (int k = 0; k < n; ++k) {
                            const float power = gamma * log2_of(std::max(colour[k] / 255, TINY));
                            colour[k] = 255 * exp2_of(std::max(power, -125.0f));
                        }
                    }
#pragma omp simd
                    for (int k = 0; k < n; ++k) {
                        const float value = std::rint(colour[k] / 255 * gain + level * grain[k]);
                        colour[k] = (std::clamp(value, 0.0f, 255.0f) - mean[c]) / deviation[c];
                    }
                }
                for (int k = 0; k < n; ++k)
                    for (int c = 0; c < COLOURS; ++c) to[k * COLOURS + c] = line[c * columns + k];
            }
        }
    }
}

// Writes bytes [count, cells]: the mask in the frame's pixel nearest to each cell's place in the view, or 0.
extern "C" void masks(Size count, Size cells, const std::uint8_t *frames, const Size *frame, Size height,
                      Size width, const float *place, const float *sampled, std::uint8_t *result) {
    for (Size b = 0; b < count; ++b) {
        const float *const m = place + 6 * b;
        const std::uint8_t *const pixels = frames + frame[b] * height * width * BYTES;
        for (Size k = 0; k < cells; ++k) {
            const float x = sampled[2 * k], y = sampled[2 * k + 1];
            const float i = std::rint(m[0] * x + m[1] * y + m[2] - 0.5f);
            const float j = std::rint(m[3] * x + m[4] * y + m[5] - 0.5f);
            const bool outside = !(i >= 0 && i < float(width) && j >= 0 && j < float(height));
            result[b * cells + k] = outside ? 0 : pixels[(Size(j) * width + Size(i)) * BYTES + COLOURS];
        }
    }
}
