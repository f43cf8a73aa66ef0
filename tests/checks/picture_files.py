"""Readers of PNG, EXR and GIF that share no code with the simulator or its libraries: for the checks of what it writes."""
import struct
import zlib


def png(path):
    """(width, height, bits, channels, [row of samples], {keyword: text}) of a non-interlaced grey or RGB PNG."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG"
    at, packed, texts, header = 8, b"", {}, None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        elif kind == b"tEXt":
            key, _, text = body.partition(b"\0")
            texts[key.decode()] = text.decode()
        at += 12 + size
    width, height, bits, colour, _, _, interlaced = header
    channels = {0: 1, 2: 3}[colour]
    assert not interlaced
    raw, step, rows = zlib.decompress(packed), channels * bits // 8, []
    length, above = width * step, bytes(width * step)
    for y in range(height):
        kind, line = raw[y * (length + 1)], bytearray(raw[y * (length + 1) + 1:(y + 1) * (length + 1)])
        for i in range(length):
            a, b = line[i - step] if i >= step else 0, above[i]
            c = above[i - step] if i >= step else 0
            if kind == 4:
                p = a + b - c
                pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
                guess = a if pa <= pb and pa <= pc else b if pb <= pc else c
            else:
                guess = (0, a, b, (a + b) // 2)[kind]
            line[i] = (line[i] + guess) & 255
        above = bytes(line)
        rows.append(above if bits == 8 else [above[i] << 8 | above[i + 1] for i in range(0, length, 2)])
    return width, height, bits, channels, rows, texts


def exr(path):
    """(width, height, {channel: (type, [samples])}, {attribute: text}) of a scan-line EXR, ZIP or none; types "uint", "half", "float"."""
    data = path.read_bytes()
    assert data[:4] == b"\x76\x2f\x31\x01", f"{path} is no EXR"
    at, channels, texts, box, compression = 8, [], {}, None, None

    def word():
        nonlocal at
        end = data.index(b"\0", at)
        text, at = data[at:end].decode(), end + 1
        return text

    while data[at]:
        name, kind = word(), word()
        size, = struct.unpack_from("<i", data, at)
        at += 4
        end = at + size
        if kind == "chlist":
            while data[at]:
                channel = word()
                channels.append((channel, struct.unpack_from("<i", data, at)[0]))
                at += 16
        elif kind == "string":
            texts[name] = data[at:end].decode()
        elif name == "dataWindow":
            box = struct.unpack_from("<4i", data, at)
        elif name == "compression":
            compression = data[at]
        at = end
    at += 1
    width, height = box[2] - box[0] + 1, box[3] - box[1] + 1
    lines = {0: 1, 2: 1, 3: 16}[compression]
    blocks = -(-height // lines)
    offsets = struct.unpack_from(f"<{blocks}Q", data, at)
    codes = {0: ("uint", "I", 4), 1: ("half", "e", 2), 2: ("float", "f", 4)}
    samples = {name: [] for name, _ in channels}
    for offset in offsets:
        y, size = struct.unpack_from("<ii", data, offset)
        body = data[offset + 8:offset + 8 + size]
        rows = min(lines, box[3] + 1 - y)
        plain = rows * width * sum(codes[kind][2] for _, kind in channels)
        if compression and len(body) < plain:
            coded = bytearray(zlib.decompress(body))
            for i in range(1, len(coded)):
                coded[i] = (coded[i - 1] + coded[i] - 128) & 255
            half = (len(coded) + 1) // 2
            body = bytearray(len(coded))
            body[0::2], body[1::2] = coded[:half], coded[half:]
        place = 0
        for _ in range(rows):
            for name, kind in channels:
                samples[name] += struct.unpack_from(f"<{width}{codes[kind][1]}", body, place)
                place += width * codes[kind][2]
    return width, height, {name: (codes[kind][0], samples[name]) for name, kind in channels}, texts


def unpack_lzw(packed, bits):
    """The symbols of a GIF's image data."""
    clear, end = 1 << bits, (1 << bits) + 1
    width, table, last, symbols = bits + 1, None, None, bytearray()
    held = count = 0
    for byte in packed:
        held |= byte << count
        count += 8
        while count >= width:
            code, held, count = held & (1 << width) - 1, held >> width, count - width
            if code == clear:
                table, width, last = [bytes([i]) for i in range(clear)] + [b"", b""], bits + 1, None
                continue
            if code == end:
                return bytes(symbols)
            if last is not None and len(table) < 4096:
                table.append(last + (table[code] if code < len(table) else last)[:1])
            symbols += table[code]
            last = table[code]
            if len(table) == 1 << width and width < 12:
                width += 1
    raise AssertionError("image data without an end")


def gif(path):
    """(width, height, [(centiseconds, RGB bytes)], comment, loops) of a GIF whose frames are whole and have palettes of their own."""
    data = path.read_bytes()
    assert data[:6] == b"GIF89a", f"{path} is no GIF"
    width, height, flags = struct.unpack_from("<HHB", data, 6)
    assert not flags & 0x80
    at, frames, comment, delay, loops = 13, [], "", None, None

    def blocks():
        nonlocal at
        whole = b""
        while data[at]:
            whole += data[at + 1:at + 1 + data[at]]
            at += 1 + data[at]
        at += 1
        return whole

    while data[at] != 0x3b:
        if data[at] == 0x21:
            label, at = data[at + 1], at + 2
            body = blocks()
            if label == 0xf9:
                delay, = struct.unpack_from("<H", body, 1)
            elif label == 0xfe:
                comment = body.decode()
            elif label == 0xff and body.startswith(b"NETSCAPE2.0"):
                loops, = struct.unpack_from("<H", body, 12)
        else:
            assert data[at] == 0x2c
            left, top, w, h, flags = struct.unpack_from("<HHHHB", data, at + 1)
            assert (left, top, w, h) == (0, 0, width, height) and flags & 0x80 and not flags & 0x40
            size = 2 << (flags & 7)
            palette, at = data[at + 10:at + 10 + 3 * size], at + 10 + 3 * size
            bits, at = data[at], at + 1
            symbols = unpack_lzw(blocks(), bits)
            assert len(symbols) == width * height, "a frame of another size than its symbols"
            frames.append((delay, b"".join(palette[3 * s:3 * s + 3] for s in symbols)))
    assert at == len(data) - 1
    return width, height, frames, comment, loops
