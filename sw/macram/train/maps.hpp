// Maps in memory, channels innermost: their numbers, and passes over them by several threads.
//
// A map of few channels is taken as one of several times as many: the vectors are full whatever the channels.
// Sums are made over pieces whose bounds depend on the shape alone, so results do not depend on the threads.
#pragma once

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
    Size count, channels, period, threads;

    Shape(Size rows, Size channels, Size threads)
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

}  // namespace
