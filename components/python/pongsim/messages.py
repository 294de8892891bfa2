"""Classes of all message types, made on first use: `pongsim.messages.Twist`.

They need Google's protobuf package (`python3-protobuf`, or protobuf from PyPI). Dicts can be used everywhere instead.
"""

from __future__ import annotations

import importlib
from typing import Any

from . import _core

_pool: Any = None
_classes: dict[str, Any] = {}


def message_class(name: str) -> Any:
    """Returns the class of a message type, named with or without `ignition.msgs.`. Raises ValueError and ImportError."""
    global _pool
    full = _core.message_type(name)
    if full in _classes:
        return _classes[full]
    try:
        descriptor_pb2, descriptor_pool, message_factory = (
            importlib.import_module("google.protobuf." + part)
            for part in ("descriptor_pb2", "descriptor_pool", "message_factory")
        )
    except ImportError as missing:
        raise ImportError("message classes need Google's protobuf package; use dicts without it") from missing
    if _pool is None:
        # a separate pool, so that other classes with the same names do not clash with these
        _pool = descriptor_pool.DescriptorPool()
    for data in _core.message_files(full):
        file = descriptor_pb2.FileDescriptorProto.FromString(data)
        try:
            _pool.FindFileByName(file.name)
        except KeyError:
            _pool.AddSerializedFile(data)
    descriptor = _pool.FindMessageTypeByName(full)
    if hasattr(message_factory, "GetMessageClass"):
        made = message_factory.GetMessageClass(descriptor)
    else:
        made = message_factory.MessageFactory(_pool).GetPrototype(descriptor)
    _classes[full] = made
    return made


def __getattr__(name: str) -> Any:
    if name.startswith("_"):
        raise AttributeError(name)
    try:
        return message_class(name)
    except ValueError as unknown:
        raise AttributeError(str(unknown)) from None


def __dir__() -> list[str]:
    return ["message_class", *(name.rpartition(".")[2] for name in _core.message_types())]
