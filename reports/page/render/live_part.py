# SPDX-License-Identifier: Apache-2.0
"""The page's live part: the model as WebAssembly, its script and its style (reports/live), and the scenes to start from."""
import base64
import gzip
import json
import pathlib

HERE = pathlib.Path(__file__).resolve().parent.parent.parent / "live"


def scenes(out):
    """The texts of the report's scenes by their names, in the order in which the page offers them."""
    return {path.stem: path.read_text(encoding="utf-8") for path in sorted((out / "data/scenes").glob("*.toml"))}


def parts(out):
    """What goes on where the page's style ends, and the elements at its end; both empty where reports/live is not there."""
    if not (HERE / "tribocheck.wasm").is_file():
        return "", ""
    # Base 85 takes a sixteenth less room than base 64. None of its signs ends a script.
    model = base64.b85encode(gzip.compress((HERE / "tribocheck.wasm").read_bytes(), 9, mtime=0)).decode()
    told = json.dumps(scenes(out), ensure_ascii=False).replace("</", "<\\/").replace("<!--", "<\\!--")
    script = (HERE / "live.js").read_text(encoding="utf-8")
    return ((HERE / "live.css").read_text(encoding="utf-8"),
            f'<script type="text/plain" id="live-wasm">{model}</script>\n'
            f'<script type="application/json" id="live-scenes">{told}</script>\n<script>\n{script}</script>\n')
