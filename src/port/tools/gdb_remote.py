"""A debugger's end of GDB's remote serial protocol: stop an emulated chip at a function, look, go on."""
import socket


class Remote:
    def __init__(self, path, seconds):
        """Connects to a Unix socket; the chip is halted by it. No answer may take longer than `seconds`."""
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(seconds)
        self.socket.connect(str(path))
        self.received = b""
        self.command("?")

    def send(self, text):
        data = text.encode()
        self.socket.sendall(b"$%b#%02x" % (data, sum(data) % 256))

    def command(self, text):
        """Sends a packet and returns the answer's text."""
        self.send(text)
        return self.answer()

    def answer(self):
        while b"$" not in self.received or b"#" not in self.received.split(b"$", 1)[1] \
                or len(self.received.split(b"$", 1)[1].split(b"#", 1)[1]) < 2:
            more = self.socket.recv(65536)
            if not more:
                raise ConnectionError("the emulator has ended")
            self.received += more
        body, rest = self.received.split(b"$", 1)[1].split(b"#", 1)
        self.received = rest[2:]
        self.socket.sendall(b"+")
        return body.decode("ascii", "replace")

    def word(self, address):
        """32 bits of the chip's memory or of its registers, little-endian."""
        return int.from_bytes(bytes.fromhex(self.command(f"m{address:x},4")), "little")

    def stop_at(self, address):
        if self.command(f"Z0,{address & ~1:x},2") != "OK":
            raise ConnectionError(f"the emulator takes no breakpoint at {address:#x}")

    def stop_no_more(self, address):
        self.command(f"z0,{address & ~1:x},2")

    def go(self, meanwhile):
        """Until the next stop; past the one where the chip is, which would stop it again at once. Calls meanwhile() on the way."""
        self.command("s")
        self.send("c")
        meanwhile()
        self.answer()
