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
QUIET = 0.15  # Seconds without an event after which the window is at rest.
ROOT = "/org/a11y/atspi/accessible/root"
FOCUSABLE, FOCUSED, PRESSED, SENSITIVE = 1 << 11, 1 << 12, 1 << 20, 1 << 24

# Of the roles of AT-SPI, those that the window has, by their numbers.
ROLES = {
    7: "check box", 11: "combo box", 16: "dialog", 23: "window", 27: "picture", 29: "label", 31: "list", 32: "list item", 33: "menu",
    35: "menu item", 37: "tab", 39: "group", 42: "progress bar", 43: "button", 44: "radio button", 48: "scroll bar", 49: "tab panel",
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
        self.running = running
        self.name = None
        self.events = collections.deque()
        self.heard = time.monotonic()
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
        self.xdotool("windowfocus", window)
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
        self.heard = time.monotonic()
        detail, one, _, value, _ = parameters.unpack()
        self.events.append((signal_name, path, detail, one, value))

    def wait(self, what, condition):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            while GLib.MainContext.default().iteration(False):
                pass
            if got := condition():
                return got
            if self.process.poll() is not None:
                sys.exit("bus: the program ended by itself")
            time.sleep(0.03)
        if self.name is None:
            sys.exit(f"bus: waited {PATIENCE} s for {what}")
        announced = [event[4] for event in self.events if event[0] == "Announcement"]
        focused = [node.place() for node in self.tree().all() if node.states & FOCUSED]
        sys.exit(f"bus: waited {PATIENCE} s for {what}\n     the focus is at {focused}\n     announced since: {announced}")

    def settle(self):
        self.heard = time.monotonic()
        self.wait("the window to come to rest", lambda: QUIET < time.monotonic() - self.heard)

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
            return "%d,%d %dx%d" % self.call("org.a11y.atspi.Component.GetExtents", node.path, GLib.Variant("(u)", (1,)))
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
        self.ask(role, name, "org.a11y.atspi.Action.DoAction", GLib.Variant("(i)", (0,)))

    def type(self, name, text):
        """Goes to a field as a screen reader does, and types in it in the place of what is there."""
        self.ask("text field", name, "org.a11y.atspi.Component.GrabFocus")
        has_focus = lambda: (field := self.find("text field", name)) and field.states & FOCUSED
        self.wait(f"the focus in the field {name!r}", has_focus)
        self.xdotool("key", "ctrl+a")
        self.xdotool("type", "--", text)
        # What is asked of the program next comes by another way than keys, and may be there before them.
        has_text = lambda: self.text_of("text field", name) == text
        self.wait(f"{text!r} in the field {name!r}", has_text)

    def key(self, key):
        self.xdotool("key", key)


def connection(address):
    flags = Gio.DBusConnectionFlags.AUTHENTICATION_CLIENT | Gio.DBusConnectionFlags.MESSAGE_BUS_CONNECTION
    return Gio.DBusConnection.new_for_address_sync(address, flags, None, None)
