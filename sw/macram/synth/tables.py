"""Synthesis and bitstream reports as Markdown and as rows for a terminal."""

from __future__ import annotations

from typing import Any

from macram.synth.devices import RESOURCES


def cost_rows(report: dict[str, Any]) -> list[list[str]]:
    """A row per module, then the total, the device, the share and the limit."""
    rows = [
        [row["name"], str(row["instances"]), *(_number(row[key]) for key in RESOURCES)]
        for row in report["modules"]
    ]
    rows.append(["total", "", *(_number(report["total"][key]) for key in RESOURCES)])
    rows.append([report["device"], "", *(_number(report["capacity"][key]) for key in RESOURCES)])
    rows.append(["share", "", *(f"{report['percent'][key]:.1f} %" for key in RESOURCES)])
    rows.append(["limit", "", *(_number(report["limits"][key]) for key in RESOURCES)])
    return rows


COST_COLUMNS = ("module", "instances", "LUT", "FF", "DSP", "BRAM")


def cost_markdown(report: dict[str, Any]) -> str:
    """`cost_rows` as a page."""
    fits = f"does not fit: {'; '.join(report['excess'])}" if report["excess"] else "fits"
    return _page(
        f"Array {report['array']['name']} on {report['device_title']}",
        [
            f"{report['note'][0].upper()}{report['note'][1:]}.",
            f"The design {fits}. Yosys took {report['seconds']:.0f} s.",
            _table(COST_COLUMNS, cost_rows(report)),
            _versions(report),
        ],
    )


BITSTREAM_COLUMNS = ("what", "value")


def bitstream_rows(report: dict[str, Any]) -> list[list[str]]:
    """One fact a row."""
    array = report["array"]
    rows = [
        ["board, part", f"{report['board']}, {report['part']}"],
        [
            "array",
            f"{array['name']}: {array['units']} units x {array['rows']} row engines ({array['engine']})",
        ],
        ["products per cycle", f"{report['peak_macs_per_cycle']:,}"],
        ["clock asked for", f"{report['clock_mhz']} MHz"],
        ["Fmax after routing", f"{report['fmax_mhz']:.2f} MHz ({'met' if report['met'] else 'NOT met'})"],
    ]
    for name, row in report["utilisation"].items():
        share = 100 * row["used"] / row["available"]
        rows.append([name, f"{row['used']:,} of {row['available']:,} ({share:.1f} %)"])
    selftest = report["selftest"]
    rows += [
        [
            "self-test",
            f"{selftest['cycles']:,} cycles, {selftest['beats_out']:,} beats, CRC-32 {selftest['crc32']}",
        ],
        ["seed", str(report["seed"])],
        ["bitstream", f"{report['bytes']:,} bytes"],
        ["SHA-256", report["sha256"]],
        *([f"seconds, {name}", f"{value:.0f}"] for name, value in report["seconds"].items()),
    ]
    return rows


def bitstream_markdown(report: dict[str, Any]) -> str:
    """`bitstream_rows` as a page."""
    return _page(
        f"Bitstream of array {report['array']['name']}",
        [_table(BITSTREAM_COLUMNS, bitstream_rows(report)), _versions(report)],
    )


def _number(value: float) -> str:
    return f"{value:,.0f}" if value == int(value) else f"{value:,.1f}"


def _table(columns: tuple[str, ...], rows: list[list[str]]) -> str:
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _versions(report: dict[str, Any]) -> str:
    return "Versions: " + ", ".join(f"{name} {version}" for name, version in report["versions"].items()) + "."


def _page(title: str, parts: list[str]) -> str:
    return f"# {title}\n\n" + "\n\n".join(parts) + "\n"
