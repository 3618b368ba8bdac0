"""What a screen reader does, for `.ci/bus`: it starts a program on a virtual screen and a bus of its own, and reads its tree."""

import collections
import contextlib
import dataclasses
import os
import subprocess
import sys
import time

from gi.repository import Gio, GLib

PATIENCE = 60  # Seconds for anything to happen, on however slow a machine.
SCALE = 0.5  # The window is drawn by the processor: in half its size in a quarter of the time, with all that is in it.
LOOKS = 4  # So often in a row nothing is at work before the window is at rest.
ROOT = "/org/a11y/atspi/accessible/root"
FOCUSABLE, FOCUSED, PRESSED, SENSITIVE = 1 << 11, 1 << 12, 1 << 20, 1 << 24

# Of the roles of AT-SPI, those that the window has, by their numbers.
ROLES = {
    7: "check box", 11: "combo box", 16: "dialog", 23: "window", 27: "picture", 29: "label", 31: "list", 32: "list item", 33: "menu",
    35: "menu item", 37: "tab", 39: "group", 40: "password field", 42: "progress bar", 43: "button", 44: "radio button", 48: "scroll bar", 49: "tab panel",
    50: "edge", 51: "slider", 52: "spin button", 54: "status", 55: "table", 56: "cell", 62: "toggle button", 64: "balloon",
    67: "unknown", 79: "text field", 85: "section", 88: "link", 90: "row", 98: "list box", 116: "text",
}  # fmt: skip


@dataclasses.dataclass
class Node:
    """One object of the tree."""

    path: str
    up: "Node | None"
    role: str
    name: str
    description: str
    states: int
    children: list = dataclasses.field(default_factory=list)

    def all(self):
        yield self
        for child in self.children:
            yield from child.all()

    def above(self):
        node = self.up
        while node:
            yield node
            node = node.up

    def takes_focus(self):
        return self.states & FOCUSABLE and self.states & SENSITIVE

    def has_focus(self):
        return self.states & FOCUSED

    def is_pressed(self):
        return self.states & PRESSED

    def place(self):
        above = f"{self.up.place()} > " if self.up else ""
        return f"{above}{self.role} {self.name[:40]!r}" if self.name else f"{above}{self.role}"


class Program:
    """The program and what a screen reader hears of it."""

    def __init__(self, program, work, running):
        self.environment = dict(os.environ, HOME=work, XDG_RUNTIME_DIR=work, LC_ALL="C.UTF-8", GSETTINGS_BACKEND="memory")
        for name in ["CONFIG", "DATA", "STATE", "CACHE"]:
            self.environment[f"XDG_{name}_HOME"] = os.path.join(work, name.lower())
        for name in ["WAYLAND_DISPLAY", "AT_SPI_BUS_ADDRESS", "LANGUAGE", "LANG"]:
            self.environment.pop(name, None)
        self.environment["WINIT_X11_SCALE_FACTOR"] = str(SCALE)
        self.running = running
        self.name = None
        self.events = collections.deque()
        self.environment["DISPLAY"] = ":" + self.serve("Xvfb", "-displayfd", "FD", "-noreset", "-screen", "0", "1280x800x24")
        address = self.serve("dbus-daemon", "--session", "--nofork", "--print-address=FD")
        self.environment["DBUS_SESSION_BUS_ADDRESS"] = address
        self.bus = connection(address)
        # A program builds its tree once somebody has said that it is read.
        switch = GLib.Variant("(ssv)", ("org.a11y.Status", "IsEnabled", GLib.Variant("b", True)))
        self.call("org.freedesktop.DBus.Properties.Set", "/org/a11y/bus", switch, name="org.a11y.Bus")
        self.bus = connection(self.call("org.a11y.Bus.GetAddress", "/org/a11y/bus", name="org.a11y.Bus"))
        flags = Gio.DBusSignalFlags.NONE
        self.bus.signal_subscribe(None, "org.a11y.atspi.Event.Object", None, None, None, flags, self.hear)
        self.process = self.start(program)
        registry = "org.a11y.atspi.Registry"
        children = lambda: self.call("org.a11y.atspi.Accessible.GetChildren", ROOT, name=registry)
        self.name = self.wait("the program on the accessibility bus", children)[0][0]
        search = ["search", "--onlyvisible", "--name", "^Fitcheck$"]
        window = self.wait("the window", lambda: self.xdotool(*search).split())[-1]
        # What the pointer rests on has a balloon, which comes and goes by itself: it goes where the window is not.
        self.xdotool("mousemove", "1279", "799")
        has_keys = lambda: self.xdotool("windowfocus", window) or self.xdotool("getwindowfocus").strip() == window
        self.wait("the keys to go to the window", has_keys)
        self.wait("the tree of the window", lambda: any(self.tree().children))

    def start(self, *command, **options):
        process = subprocess.Popen(command, env=self.environment, start_new_session=True, **options)
        self.running.append(process)
        return process

    def serve(self, *command):
        """Starts a server that writes where it can be found to the file FD; returns that once it can be used."""
        reads, writes = os.pipe()
        self.start(*(part.replace("FD", str(writes)) for part in command), pass_fds=[writes], stderr=subprocess.DEVNULL)
        os.close(writes)
        with os.fdopen(reads) as pipe:
            return pipe.readline().strip() or sys.exit(f"bus: {command[0]} did not start")

    def call(self, method, path, parameters=None, name=None):
        interface, _, member = method.rpartition(".")
        flags = Gio.DBusCallFlags.NONE
        name = name or self.name
        answer = self.bus.call_sync(name, path, interface, member, parameters, None, flags, PATIENCE * 1000, None).unpack()
        return answer[0] if answer else None

    def hear(self, _connection, _sender, path, _interface, signal_name, parameters):
        detail, one, _, value, _ = parameters.unpack()
        self.events.append((signal_name, path, detail, one, value))

    def wait(self, what, condition, pause=0.03):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            while GLib.MainContext.default().iteration(False):
                pass
            if got := condition():
                return got
            if self.process.poll() is not None:
                sys.exit("bus: the program ended by itself")
            time.sleep(pause)
        if self.name is None:
            sys.exit(f"bus: waited {PATIENCE} s for {what}")
        announced = [event[4] for event in self.events if event[0] == "Announcement"]
        focused = [node.place() for node in self.tree().all() if node.has_focus()]
        sys.exit(f"bus: waited {PATIENCE} s for {what}\n     the focus is at {focused}\n     announced since: {announced}")

    def settle(self):
        """Waits until the program and its screen have nothing to do: all that was sent has been drawn, however slow the machine."""
        looks = 0

        def is_at_rest():
            nonlocal looks
            looks = 0 if any(is_at_work(process.pid) for process in self.running) else looks + 1
            return LOOKS <= looks

        self.wait("the window to come to rest", is_at_rest, pause=0.01)

    def xdotool(self, *words):
        done = subprocess.run(["xdotool", *words], env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        return done.stdout

    def tree(self):
        """What is on the bus now: one answer, so that it is of one frame. Returns the window."""
        items = self.call("org.a11y.atspi.Cache.GetItems", "/org/a11y/atspi/cache")
        nodes, order = {}, []
        for (_, path), _app, (_, parent), index, _count, _interfaces, name, role, description, states in items:
            nodes[path] = Node(path, None, ROLES.get(role, f"role {role}"), name, description, states[0])
            order.append((index, path, parent))
        for _, path, parent in sorted(order):
            if path != ROOT and parent in nodes:
                nodes[parent].children.append(nodes[path])
                nodes[path].up = nodes[parent] if parent != ROOT else None
        return nodes[ROOT].children[0] if nodes[ROOT].children else nodes[ROOT]

    def bounds(self, node):
        """Left, top, width and height within the window."""
        with contextlib.suppress(GLib.Error):
            extents = self.call("org.a11y.atspi.Component.GetExtents", node.path, GLib.Variant("(u)", (1,)))
            return "%d,%d %dx%d" % tuple(pixels / SCALE for pixels in extents)
        return "no bounds"

    def find(self, role, name):
        """The first of a role whose name begins so."""
        return next((node for node in self.tree().all() if node.role == role and node.name.startswith(name)), None)

    def ask(self, role, name, method, parameters=None):
        """Asks the first of a role whose name begins so for something, once it is there and can be asked."""

        def asked():
            node = self.find(role, name)
            # What has just come is told of before it can be asked.
            with contextlib.suppress(GLib.Error):
                return node and self.call(method, node.path, parameters)

        self.wait(f"the {role} {name!r}", asked)

    def text_of(self, role, name):
        with contextlib.suppress(GLib.Error):
            node = self.find(role, name)
            return node and self.call("org.a11y.atspi.Text.GetText", node.path, GLib.Variant("(ii)", (0, -1)))

    def press(self, name, role="button"):
        """Presses what has this name, as a screen reader does."""
        self.settle()
        self.ask(role, name, "org.a11y.atspi.Action.DoAction", GLib.Variant("(i)", (0,)))
        self.settle()

    def type(self, name, text, role="text field"):
        """Goes to a field as a screen reader does, and types in it in the place of what is there."""
        self.settle()
        self.ask(role, name, "org.a11y.atspi.Component.GrabFocus")
        self.wait(f"the focus in the field {name!r}", lambda: (field := self.find(role, name)) and field.has_focus())
        self.key("ctrl+a")
        self.xdotool("type", "--", text)
        # What is asked of the program next comes by another way than keys, and may be there before them.
        shown = "•" * len(text) if role == "password field" else text
        self.wait(f"{text!r} in the field {name!r}", lambda: self.text_of(role, name) == shown)

    def key(self, *keys):
        self.settle()
        self.xdotool("key", *keys)
        self.settle()


def is_at_work(process):
    """Whether a thread of it runs, would run, or waits for a disk."""
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):
        for thread in os.listdir(f"/proc/{process}/task"):
            with open(f"/proc/{process}/task/{thread}/stat") as file:
                if file.read().rpartition(")")[2].split()[0] in "RD":
                    return True
    return False


def connection(address):
    flags = Gio.DBusConnectionFlags.AUTHENTICATION_CLIENT | Gio.DBusConnectionFlags.MESSAGE_BUS_CONNECTION
    return Gio.DBusConnection.new_for_address_sync(address, flags, None, None)
