#!/usr/bin/env python3
"""Lays files of a stranger before the program: each is refused at once, with little memory and a message that a terminal
can show. Usage: hostile_files_test.py MESOPIX"""
import os, re, struct, subprocess, sys, tempfile, zlib
from pathlib import Path

import h5py
import numpy as np

mesopix = Path(sys.argv[1]).resolve()
most_memory = 300 << 20  # [bytes], of which the program itself and its libraries take 100 MiB
small = ["--width", "20 mm", "--height", "20 mm", "--pixel-size", "1 mm", "--d-min", "4 mm", "--d-max", "8 mm", "--fraction", "0.3"]
most_time = 20  # [s] of the processor, so that others may use the machine too


def run(*words):
    """Exit code, and all that was said."""
    with tempfile.TemporaryFile() as said:
        program = subprocess.Popen([mesopix, *words], stdin=subprocess.DEVNULL, stdout=said, stderr=subprocess.STDOUT)
        _, status, used = os.wait4(program.pid, 0)
        program.returncode = os.waitstatus_to_exitcode(status)
        took = used.ru_utime + used.ru_stime
        said.seek(0)
        text = said.read().decode(errors="surrogateescape")
    assert took < most_time, f"{words}: {took:.0f} s"
    assert used.ru_maxrss << 10 < most_memory, f"{words}: {used.ru_maxrss >> 10} MiB"
    obeyed = re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\udc80-\udcff]", text)
    assert not obeyed, f"{words}: a terminal would obey {obeyed[0]!r} in {text!r}"
    print(f"{took:5.2f} s {used.ru_maxrss >> 10:5} MiB  {text.splitlines()[0][:150] if text else ''}")
    return program.returncode, text


def refused(words, code, what, lines=1):
    met, said = run(*words)
    assert met == code, f"{words}: exit code {met}, not {code}: {said}"
    assert what in said, f"{words}: no '{what}' in: {said}"
    assert len(said.splitlines()) <= lines, f"{words}: {len(said.splitlines())} lines: {said}"


def png_chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def write_png(path, edge, bits):
    """Black, whatever the size; packed as tight as deflate can."""
    packer, row = zlib.compressobj(1), bytes(1 + edge * bits // 8)
    data = b"".join(packer.compress(row) for _ in range(edge)) + packer.flush()
    head = struct.pack(">IIBBBBB", edge, edge, bits, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", head) + png_chunk(b"IDAT", data) + png_chunk(b"IEND", b""))


def write_tiff(path, edge, tile):
    """Black, in tiles."""
    data = zlib.compress(bytes(min(tile * tile, 1 << 26)), 9)
    tags = [(256, edge), (257, edge), (258, 8), (259, 8), (262, 1), (277, 1), (322, tile), (323, tile), (324, 8), (325, len(data))]
    directory = b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags)
    path.write_bytes(b"II*\0" + struct.pack("<I", 8 + len(data)) + data + struct.pack("<H", len(tags)) + directory + bytes(4))


def pictures():
    # 12 bytes a pixel at most, beside the program itself.
    write_png(Path("bomb.png"), 4000, 8)
    met, said = run("convert", "bomb.png", "--pixel-size", "1 mm", "-o", "s.h5")
    assert met == 0, said
    write_png(Path("large.png"), 32000, 1)
    convert = ["convert", "large.png", "--pixel-size", "1 mm", "-o", "s.h5"]
    refused(convert, 65, "large.png: 32000 x 32000 pixels; at most 200000000 pixels are allowed")
    refused(["inspect", "large.png"], 65, "large.png: 32000 x 32000 pixels")
    write_tiff(Path("tiles.tif"), 16, 32768)
    refused(["convert", "tiles.tif", "--pixel-size", "1 mm", "-o", "s.h5"], 65, "tiles.tif: has tiles of 32768 x 32768 pixels")


def texts():
    Path("endless.toml").symlink_to("/dev/zero")
    os.mkfifo("pipe.toml")
    os.mkfifo("pipe.png")
    for name in "endless.toml", "pipe.toml", "pipe.png":
        for command in (["simulate"], ["convert"], ["scene", "check"], ["inspect"], ["study"], ["generate", "--ellipses"]):
            refused([*command, name], 74, f"{name}: is not a regular file")
    for name, text in {"keys": "a" + ".a" * 100_000 + " = 1", "lists": "a = " + "[" * 100_000, "tables": "a = " + "{a = " * 100_000}.items():
        Path(f"{name}.toml").write_text(text)
        refused(["simulate", f"{name}.toml"], 65, "nested too deep")
        refused(["scene", "check", f"{name}.toml"], 65, "nested too deep")
    Path("many.toml").write_text("".join(f"key_{i} = 1\n" for i in range(300_000)))
    refused(["simulate", "many.toml"], 65, "and at least 80 more", lines=21)
    refused(["scene", "check", "many.toml"], 65, "key_1: unknown key", lines=100)
    Path("broken.toml").write_text("key\n" * 300_000)
    refused(["scene", "check", "broken.toml"], 65, "not TOML")
    Path("list.csv").write_text("x_mm,y_mm,a_mm,b_mm\n" + "1,2,3\n" * 300_000)
    refused(["generate", "--ellipses", "list.csv", "-o", "s.h5"], 65, "and at least 80 more", lines=21)
    Path("long.toml").write_text("a" * (1 << 23) + " = 1")
    refused(["simulate", "long.toml"], 65, "unknown key")


def tricks():
    """What a terminal would obey, in a key, a value, a name of a file."""
    evil = "\x1b[2J\x9b31m\u202e\x07"
    Path("evil.toml").write_text(f'"{evil}" = 1\n')
    for words in (["simulate"], ["scene", "check"], ["scene", "check", "--json"]):
        met, said = run(*words, "evil.toml")
        assert met == 65, said
    for value in (evil, "\x1b]0;title\x07", "\x9b2J"):
        written = "".join(f"\\u{ord(letter):04x}" for letter in value)
        Path("evil.toml").write_text(f'[loading]\nvelocity = "{written}"\n')
        refused(["simulate", "evil.toml"], 65, "evil.toml:2:12")
        Path("evil.toml").write_text(f'[output]\ntitle = "{written}"\n')
        met, said = run("simulate", "--print-scene", "evil.toml")
        assert met == 0 and "title = " in said, said
    name = f"a {evil}\n'\"</script>".replace("/", "_") + ".h5"
    refused(["inspect", name], 74, "a ")
    for more in ([], ["--json"]):
        met, said = run("generate", *small, "-o", name, *more)
        assert met == 0 and Path(name).exists(), said
    met, said = run("inspect", name)
    assert met == 0, said


def pages():
    """Nothing that a name or a title says becomes part of the page of a run."""
    name = "<script>INJECTED&'\".h5"
    met, said = run("generate", *small, "-o", name)
    assert met == 0, said
    met, said = run("simulate", name, "--title", "</script><script>INJECTED", "--velocity", "1 m/s", "--stop-strain", "1e-5", "-o", "run")
    assert met == 0, said
    page = Path("run/report.html").read_text()
    assert "INJECTED" in page and "<script>INJECTED" not in page, re.search(".{80}<script>INJECTED", page)[0]


def renamed(source, path, names):
    """The specimen with other names for its phases."""
    path.write_bytes(source.read_bytes())
    with h5py.File(path, "r+") as file:
        length = max(map(len, names))
        del file["phases"]
        kind = h5py.h5t.TypeID.copy(h5py.h5t.C_S1)
        kind.set_size(length)
        kind.set_cset(h5py.h5t.CSET_UTF8)
        kind.set_strpad(h5py.h5t.STR_NULLPAD)
        space = h5py.h5s.create_simple((len(names),))
        phases = h5py.h5d.create(file.id, b"phases", kind, space)
        phases.write(space, space, np.array(names, f"S{length}"), kind)


def phases():
    """Names that would begin a line, end a quotation, or start a script."""
    met, said = run("generate", *small, "-o", "good.h5")
    assert met == 0, said
    with h5py.File("good.h5") as file:
        count = len(file["phases"])
    injected = [b"one\n*INJECTED", b'two"\n$INJECTED', b"three]]></INJECTED>", b"four\x1b[2J\x9b\r\nINJECTED,", b"\xff\xfe</script>INJECTED"]
    renamed(Path("good.h5"), Path("evil.h5"), (injected + [b"p%d" % i for i in range(count)])[:count])
    for command in (["inspect"], ["inspect", "--json"], ["simulate"]):
        run(*command[:1], "evil.h5", *command[1:])
    begins_a_line = rb"(?m)^[^\w\n]*INJECTED|[\x00-\x09\x0b-\x1f]"
    for ending, hurts in {"inp": begins_a_line, "msh": begins_a_line + rb'|"[^"\n]*"[^"\n]*"', "vti": rb"</?INJECTED"}.items():
        met, said = run("export", "evil.h5", "--to", ending)
        assert met == 0, said
        text = Path(f"evil.{ending}").read_bytes()
        found = re.search(hurts, text)
        assert not found, f"{ending}: {found[0]!r}"


def archives():
    """HDF5 files that claim more than anybody has."""
    run("generate", *small, "-o", "claims.h5")
    with h5py.File("claims.h5", "r+") as file:
        kept = dict(file["labels"].attrs)
        del file["labels"]
        file.create_dataset("labels", (1 << 18, 1 << 18), "u1", chunks=(4096, 4096), compression=9)
        file["labels"].attrs.update(kept)
    refused(["inspect", "claims.h5"], 65, "262144 x 262144 values; must be at most 200000000")
    # A checksum that fails.
    run("generate", *small, "-o", "good.h5")
    run("simulate", "good.h5", "--velocity", "1 m/s", "--stop-strain", "1e-5", "-o", "run")
    with h5py.File("run/result.h5") as file:
        chunk = file["failure_strain"].id.get_chunk_info(0)
    result = bytearray(Path("run/result.h5").read_bytes())
    result[chunk.byte_offset + chunk.size // 2] ^= 1
    Path("run/result.h5").write_bytes(result)
    refused(["inspect", "run"], 74, "is damaged: its digest does not match its bytes")
    refused(["plot", "run", "-o", "damage.png"], 74, "is damaged: its digest does not match its bytes")
    Path("run/result.h5").write_bytes(result[:-40])  # as another program would have written it
    refused(["inspect", "run"], 65, "dataset failure_strain is damaged")
    refused(["plot", "run", "-o", "damage.png"], 74, "dataset failure_strain is damaged")


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for part in (pictures, texts, tricks, pages, phases, archives):
        part()
