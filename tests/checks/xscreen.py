"""A virtual X screen with real input events: Xvfb, xdotool, and a capture of what a window shows, by Xlib itself."""
import ctypes
import os
import subprocess
import time


class XImage(ctypes.Structure):
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int), ("format", ctypes.c_int),
                ("data", ctypes.POINTER(ctypes.c_ubyte)), ("byte_order", ctypes.c_int), ("bitmap_unit", ctypes.c_int),
                ("bitmap_bit_order", ctypes.c_int), ("bitmap_pad", ctypes.c_int), ("depth", ctypes.c_int), ("bytes_per_line", ctypes.c_int),
                ("bits_per_pixel", ctypes.c_int)]


class Screen:
    """`with Screen() as screen:`; DISPLAY for programs is in screen.environment."""

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"], pass_fds=[write],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.name = ":" + pipe.readline().strip()
        self.environment = {**os.environ, "DISPLAY": self.name, "SDL_VIDEODRIVER": "x11"}
        for _ in range(100): # until it answers
            if subprocess.run(["xdotool", "getdisplaygeometry"], env=self.environment, capture_output=True).returncode == 0:
                return self
            time.sleep(0.1)
        raise AssertionError("Xvfb does not answer")

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()

    def do(self, *words):
        """xdotool; returns what it prints."""
        return subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True, check=True).stdout.strip()

    def window(self, title, seconds=20):
        """The number of the visible window with this in its title."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], env=self.environment, capture_output=True, text=True)
            if found.stdout.split():
                return int(found.stdout.split()[-1])
            time.sleep(0.05)
        raise AssertionError(f"no window with the title {title}")

    def capture(self, window, width, height):
        """RGB bytes of the window's upper left part."""
        x = ctypes.CDLL("libX11.so.6")
        x.XOpenDisplay.restype = ctypes.c_void_p
        x.XGetImage.restype = ctypes.POINTER(XImage)
        x.XGetImage.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_int, ctypes.c_uint, ctypes.c_uint, ctypes.c_ulong,
                                ctypes.c_int]
        x.XCloseDisplay.argtypes = [ctypes.c_void_p]
        display = x.XOpenDisplay(self.name.encode())
        image = x.XGetImage(display, window, 0, 0, width, height, 0xffffffff, 2).contents
        assert image.bits_per_pixel == 32 and image.byte_order == 0
        raw = ctypes.string_at(image.data, image.bytes_per_line * height)
        x.XCloseDisplay(display)
        rows = []
        for y in range(height):
            row = raw[y * image.bytes_per_line:y * image.bytes_per_line + 4 * width]
            rgb = bytearray(3 * width)
            rgb[0::3], rgb[1::3], rgb[2::3] = row[2::4], row[1::4], row[0::4]
            rows.append(bytes(rgb))
        return rows
