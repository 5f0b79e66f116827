"""The packer: a layer as the memory words of one array, and back."""

from macram.pack.layout import BIT_ORDER
from macram.pack.packed import PackedLayer, pack_layer, pack_passes, read_packed, unpack

__all__ = ["BIT_ORDER", "PackedLayer", "pack_layer", "pack_passes", "read_packed", "unpack"]
