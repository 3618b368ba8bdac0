"""The hashes of the chain in this folder, as docs/JOURNAL.md says: python3 hashes.py prints hashes.txt."""

import hashlib
import pathlib

folder = pathlib.Path(__file__).parent
chain = bytes.fromhex("000102030405060708090a0b0c0d0e0f")
previous = bytes(32)
for number in (1, 2, 3, 4):
    body = (folder / f"{number}.json").read_bytes()
    frame = b"fitcheck entry 1\0" + previous
    frame += len(chain).to_bytes(4, "big") + chain
    frame += number.to_bytes(8, "big")
    frame += len(body).to_bytes(4, "big") + body
    previous = hashlib.sha256(frame).digest()
    print(number, previous.hex())
