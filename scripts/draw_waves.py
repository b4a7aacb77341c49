#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/waves/*.svg, with their WaveJSON beside them, from a simulation of tests/rtl/waves_tb.sv in Icarus: the drawings
show what the RTL does. With --check it writes nothing and fails when one of them is out of date."""

import json
import subprocess
import tempfile
from pathlib import Path

from generated import ROOT, write_or_check

OUT = ROOT / "docs/waves"
DRAWINGS = {  # name: (clocks, signals)
    "skid_buffer": (10, "skid_tvalid skid_tready skid_tdata skid_m_tvalid skid_m_tready skid_m_tdata"),
    "stream_fifo": (13, "fifo_push fifo_level fifo_m_tvalid fifo_m_tready fifo_m_tdata"),
    "stream_merge": (7, "merge_tvalid merge_tready merge_m_tvalid merge_m_tdata"),
    "axil_slave": (11, "axil_awvalid axil_awready axil_write axil_bvalid axil_arvalid axil_arready "
                       "axil_read_address axil_rvalid axil_rdata"),
    "frame_guard": (23, "guard_tvalid guard_tready guard_tuser guard_tlast pixel_step pixel_commit line_valid "
                        "line_whole line_first line_last line_fault events"),
}
STEP, HEIGHT, ROW, LEFT = 36, 18, 30, 150  # px


def simulate():
    """Per clock from clock 0 on, the value of each signal just before the rising edge: (value, bits)."""
    with tempfile.TemporaryDirectory() as work:
        sources = [ROOT / "rtl/trihedron_registers.sv"]
        sources += sorted(f for f in (ROOT / "rtl").glob("*.sv") if f not in sources)
        subprocess.run(["iverilog", "-g2012", "-o", "waves", "-s", "waves_tb", *map(str, sources),
                        str(ROOT / "tests/rtl/waves_tb.sv")], cwd=work, check=True, stderr=subprocess.DEVNULL)
        subprocess.run(["vvp", "-n", "waves"], cwd=work, check=True, stdout=subprocess.DEVNULL)
        lines = (Path(work) / "waves.vcd").read_text().splitlines()
    names, bits, now, clocks = {}, {}, {}, []
    for line in lines:
        word = line.split()
        if line.startswith("$var"):
            names[word[3]], bits[word[4]] = word[4], int(word[2])
        elif line and line[0] in "01xz":
            now[names[line[1:]]] = line[0]
        elif line.startswith("b"):
            now[names[word[1]]] = word[0][1:]
        elif line.startswith("#"):  # all changes of the time before are in
            if int(line[1:]) % 10 == 5:
                clocks.append(dict(now))
    start = next(i for i, clock in enumerate(clocks) if int(clock["at"], 2) == 0)
    return clocks[start:], bits


def value(text):
    return None if set(text) - set("01") else f"{int(text, 2):x}"


def wave(signal, clocks, bits):
    """One signal in WaveJSON."""
    values = [value(clock[signal]) for clock in clocks]
    name = signal.split("_", 1)[1] if signal.split("_")[0] in ("skid", "fifo", "merge", "axil", "guard") else signal
    text, data, before = "", [], object()
    for now in values:
        if now == before:
            text += "."
        elif now is None:
            text += "x"
        elif bits == 1:
            text += now
        else:
            text += "="
            data.append(now)
        before = now
    return {"name": name, "wave": text, **({"data": data} if data else {})}


def draw(signals):
    """WaveJSON signals as SVG."""
    clocks = len(signals[0]["wave"])
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{LEFT + clocks * STEP + 10}" '
           f'height="{ROW * (len(signals) + 1)}" font-family="monospace" font-size="12">',
           '<rect width="100%" height="100%" fill="white"/>']
    for clock in range(clocks):
        x = LEFT + clock * STEP
        out.append(f'<text x="{x + STEP / 2}" y="14" text-anchor="middle" fill="#666">{clock}</text>')
        out.append(f'<path d="M{x} 20V{ROW * (len(signals) + 1) - 4}" stroke="#ddd" fill="none"/>')
    for row, signal in enumerate(signals):
        bottom = ROW * (row + 2) - 8
        out.append(f'<text x="{LEFT - 8}" y="{bottom - 4}" text-anchor="end">{signal["name"]}</text>')
        data, level, begin = list(signal.get("data", [])), "x", 0
        text = signal["wave"]
        for clock in range(clocks):
            if text[clock] != ".":
                before, level, begin = level, text[clock], clock
                if level in "01" and before in "01" and clock:
                    out.append(f'<path d="M{LEFT + clock * STEP} {bottom - HEIGHT}v{HEIGHT}" stroke="black"/>')
            if clock + 1 < clocks and text[clock + 1] == ".":
                continue
            x, width = LEFT + begin * STEP, (clock + 1 - begin) * STEP
            if level in "01":
                y = bottom - HEIGHT * int(level)
                out.append(f'<path d="M{x} {y}h{width}" stroke="black"/>')
                continue
            fill = "#eee" if level == "x" else "#dfeaf7"
            out.append(f'<rect x="{x + 1}" y="{bottom - HEIGHT}" width="{width - 2}" height="{HEIGHT}" rx="4" '
                       f'fill="{fill}" stroke="black" stroke-width="0.7"/>')
            if level == "=":
                out.append(f'<text x="{x + width / 2}" y="{bottom - 5}" text-anchor="middle">{data.pop(0)}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    clocks, bits = simulate()
    files = {}
    for name, (count, signals) in DRAWINGS.items():
        waves = [wave(signal, clocks[:count], bits[signal]) for signal in signals.split()]
        files[OUT / f"{name}.json"] = json.dumps(
            {"signal": waves, "head": {"text": name, "tick": 0}}, indent=1) + "\n"
        files[OUT / f"{name}.svg"] = draw(waves)
    write_or_check(__doc__, files)


if __name__ == "__main__":
    main()
