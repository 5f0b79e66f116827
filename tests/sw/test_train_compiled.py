"""The compiled operations of training on a CPU give PyTorch's numbers, and training goes on without them."""

from __future__ import annotations

import copy
import ctypes
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from torch import nn
from torch.nn import functional
from train_scene import write_scene

from macram.front.image import IMAGENET_STD
from macram.model import Levels
from macram.model.backbone import ResidualUnit
from macram.quant.lsq import LsqQuantizer
from macram.spec import IntFormat
from macram.train import compiled, norm_relu
from macram.train.augment import AugmentSettings
from macram.train.lsq_cpu import CpuQuantizer, fuse_quantizers
from macram.train.norm_relu import RectifyingBatchNorm2d, fuse_batch_norm
from macram.train.pack import pack_frames
from macram.train.pictures import draw_pictures
from macram.train.settings import DataSettings
from macram.train.views import draw_views
from macram.train.warp import NOISE_STRIDE, Cells, Warper

CPU = torch.device("cpu")
LEVELS = Levels()


# ---- batch normalisation, ReLU, sum -----------------------------------------------------------------


def pair(channels):
    """PyTorch's layer in float64, and the fused one."""
    plain = nn.BatchNorm2d(channels)
    draw = torch.Generator().manual_seed(channels)
    with torch.no_grad():
        plain.weight.uniform_(-1, 2, generator=draw)  # negative slopes too
        plain.bias.normal_(generator=draw)
    fused = copy.deepcopy(plain)
    fuse_batch_norm(fused)
    assert type(fused) is RectifyingBatchNorm2d
    return plain.double(), fused


def outcome(layer, x, plus, grad):
    """Result, gradients, running statistics; and values in front of the ReLU, whose sign decides gradients."""
    x = x.clone().requires_grad_()
    plus = None if plus is None else plus.clone().requires_grad_()
    if isinstance(layer, RectifyingBatchNorm2d):
        y, before = layer.rectified(x, plus), None
    else:
        before = layer(x)
        y = torch.relu(before)
        y = y if plus is None else y + plus
    y.backward(grad)
    to_plus = None if plus is None else plus.grad
    return before, [y, x.grad, to_plus, layer.weight.grad, layer.bias.grad, *layer.buffers()]


def compare(ours, theirs, safe, rtol, atol):
    for mine, true in zip(ours, theirs, strict=True):
        if mine is None:
            assert true is None
            continue
        places = safe if mine.shape == safe.shape else ...
        torch.testing.assert_close(mine[places].double(), true[places].double(), rtol=rtol, atol=atol)


@pytest.mark.parametrize("channels", [1, 3, 8, 17, 64, 300])
@pytest.mark.parametrize("size", [(1, 1), (5, 7), (32, 32)])
@pytest.mark.parametrize("summed", [False, True])
def test_norm_relu_is_that_of_pytorch(channels, size, summed):
    draw = torch.Generator().manual_seed(channels + size[0])
    plain, fused = pair(channels)
    for layout in (torch.channels_last, torch.contiguous_format):  # running statistics follow over both
        shape = (6, channels, *size)
        x, plus, grad = (torch.randn(shape, generator=draw).to(memory_format=layout) for _ in range(3))
        x = 2 * x + 5
        plus = plus if summed else None
        for layer in (plain, fused):
            layer.zero_grad()
        before, theirs = outcome(plain, x.double(), None if plus is None else plus.double(), grad.double())
        _, ours = outcome(fused, x, plus, grad)
        safe = before.detach().abs() > 1e-4
        assert safe.float().mean() > 0.9
        compare(ours, theirs, safe, 1e-4, 1e-4)
    assert fused.num_batches_tracked == 2


def test_mixed_precision_rounds_once():
    draw = torch.Generator().manual_seed(3)
    plain, fused = pair(24)
    x = (50 + torch.randn(4, 24, 33, 32, generator=draw)).bfloat16().to(memory_format=torch.channels_last)
    plus, grad = (torch.randn(x.shape, generator=draw).bfloat16() for _ in range(2))
    before, theirs = outcome(plain, x.double(), plus.double(), grad.double())
    _, ours = outcome(fused, x, plus, grad)
    assert [value.dtype for value in ours[:5]] == [torch.bfloat16] * 3 + [torch.float32] * 2
    safe = before.detach().abs() > 1e-3
    compare(ours[:3], theirs[:3], safe, 2**-8, 1e-5)  # half a unit of eight bits
    compare(ours[3:], theirs[3:], safe, 1e-4, 1e-3)


def same_with_any_threads(compute):
    threads, results = torch.get_num_threads(), []
    try:
        for count in (1, 2, 3):
            torch.set_num_threads(count)
            results.append(compute())
    finally:
        torch.set_num_threads(threads)
    for other in results[1:]:
        assert all(torch.equal(a, b) for a, b in zip(results[0], other, strict=True))


def test_results_do_not_depend_on_threads():
    x = torch.randn(8, 48, 40, 41, generator=torch.Generator().manual_seed(1))
    same_with_any_threads(lambda: outcome(pair(48)[1], x, x, x)[1])


def test_constant_channels_and_gradients_of_one_number():
    plain, fused = pair(5)
    x = torch.full((3, 5, 4, 4), 1e4)
    expanded = torch.ones(1).expand(3, 5, 4, 4)  # as the gradient of a sum is
    before, theirs = outcome(plain, x.double(), None, expanded.double())
    compare(outcome(fused, x, None, expanded)[1], theirs, before.abs() > 1e-4, 1e-4, 1e-3)


def test_what_is_no_number_stays_none():
    _, fused = pair(4)
    x = torch.randn(2, 4, 3, 3, generator=torch.Generator().manual_seed(1))
    x[1, 2, 0, 0] = float("nan")
    y = fused.rectified(x)
    assert y[:, 2].isnan().all()
    assert not y[:, [0, 1, 3]].isnan().any()


def test_other_cases_go_pytorchs_way():
    plain, fused = pair(4)
    x = torch.randn(2, 4, 3, 3, generator=torch.Generator().manual_seed(2))
    assert torch.equal(
        fused.rectified(x, x[:, :, :1, :1]), torch.relu(copy.deepcopy(fused)(x)) + x[:, :, :1, :1]
    )
    with pytest.raises(ValueError, match="more than 1 value per channel"):
        fused.rectified(x[:1, :, :1, :1])
    plain = plain.float().eval()
    fused.load_state_dict(plain.state_dict())
    fused.eval()
    assert torch.equal(fused.rectified(x, x), x + torch.relu(plain(x)))
    fused.requires_grad_(False)
    assert fused.rectified(x.clone().requires_grad_()).requires_grad


@pytest.mark.parametrize("channels", [1, 3, 17, 64, 300])
@pytest.mark.parametrize("summed", [False, True])
@pytest.mark.parametrize("dtype", [torch.float32, torch.bfloat16])
def test_a_frozen_layer_is_one_pass_with_its_own_statistics(channels, summed, dtype, monkeypatch):
    draw = torch.Generator().manual_seed(channels)
    plain, fused = pair(channels)
    with torch.no_grad():
        plain.running_mean.normal_(generator=draw)
        plain.running_var.uniform_(0.1, 3, generator=draw)
    fused.load_state_dict(plain.state_dict())
    plain.eval()
    fused.eval().requires_grad_(False)
    before = [buffer.clone() for buffer in fused.buffers()]
    x, plus = (torch.randn(5, channels, 6, 7, generator=draw).to(dtype) for _ in range(2))
    plus = plus if summed else None
    passes = []
    monkeypatch.setattr(norm_relu, "_call", lambda *a, call=norm_relu._call: passes.append(a[0]) or call(*a))
    y = fused.rectified(x, plus)
    assert passes == ["apply"]
    assert y.dtype == dtype
    true = torch.relu(plain(x.double())) + (0 if plus is None else plus.double())
    torch.testing.assert_close(y.double(), true, rtol=2**-8 if dtype == torch.bfloat16 else 1e-5, atol=1e-5)
    assert all(torch.equal(a, b) for a, b in zip(before, fused.buffers(), strict=True))
    fused.requires_grad_(True)
    with torch.no_grad():
        assert torch.equal(fused.rectified(x, plus), y)
    passes.clear()
    assert fused.rectified(x.float()).requires_grad
    assert passes == []


def test_frozen_statistics_do_not_move():
    _, fused = pair(4)
    fused.track_running_stats = False
    before = copy.deepcopy(fused.state_dict())
    fused.rectified(torch.randn(2, 4, 8, 8, generator=torch.Generator().manual_seed(5)))
    assert all(torch.equal(value, before[name]) for name, value in fused.state_dict().items())


@pytest.mark.parametrize("activation", ["relu", "leaky"])
def test_residual_units_are_the_same(activation):
    draw = torch.Generator().manual_seed(4)
    unit = ResidualUnit(16, activation)
    for parameter in unit.parameters():
        nn.init.normal_(parameter, std=0.2, generator=draw)
    fused = copy.deepcopy(unit)
    fuse_batch_norm(fused)
    x = torch.randn(2, 16, 9, 10, generator=draw).to(memory_format=torch.channels_last)
    results = []
    for module in (unit, fused):
        inner = x.clone().requires_grad_()
        module(inner).square().sum().backward()
        results.append([inner.grad, *(p.grad for p in module.parameters())])
    for mine, true in zip(*results, strict=True):
        torch.testing.assert_close(mine, true, rtol=1e-3, atol=1e-3)
    plain = functional.relu if activation == "relu" else lambda v: functional.leaky_relu(v, 0.1)
    inner = plain(unit.reduce.bn(unit.reduce.conv(x)))
    want = x + plain(unit.expand.bn(unit.expand.conv(inner)))
    torch.testing.assert_close(fused(x), want, rtol=1e-4, atol=1e-4)


# ---- quantisers ---------------------------------------------------------------------------------------


def quantizers(bits_format, step):
    """PyTorch's operations, and one pass."""
    plain = LsqQuantizer(bits_format, batched=True)
    with torch.no_grad():
        plain.step.fill_(step)
    fused = copy.deepcopy(plain)
    fuse_quantizers(fused)
    assert type(fused) is CpuQuantizer
    return plain, fused


def quantised(layer, v, grad):
    layer.zero_grad()
    v = v.clone().requires_grad_()
    y = layer(v)
    y.backward(grad)
    return y.detach(), v.grad, layer.step.grad


@pytest.mark.parametrize(
    "shape", [(1, 1, 1, 1), (3, 5, 7, 9), (4, 32, 16, 16), (2, 300, 1, 3), (1, 8, 200, 200)]
)
@pytest.mark.parametrize("code_format", [IntFormat(3), IntFormat(3, signed=True), IntFormat(8), IntFormat(1)])
def test_a_quantiser_in_one_pass_is_pytorchs(shape, code_format):
    draw = torch.Generator().manual_seed(sum(shape))
    plain, fused = quantizers(code_format, 0.37)
    v, grad = (2 * torch.randn(shape, generator=draw) for _ in range(2))
    v.view(-1)[::11] = float("inf")
    v.view(-1)[::7] = 0.37 * (
        torch.randint(-9, 9, v.view(-1)[::7].shape, generator=draw) / 2
    )  # ties and bounds
    for layout in (torch.channels_last, torch.contiguous_format):
        maps = [value.to(memory_format=layout) for value in (v, grad)]
        (y, to_v, to_step), mine = quantised(plain, *maps), quantised(fused, *maps)
        assert torch.equal(mine[0], y)
        assert torch.equal(mine[1], to_v)
        assert abs(float(mine[2] - to_step)) <= 1e-5 * float(grad.abs().sum()) * plain.gradient_scale(v)


def test_a_quantiser_of_mixed_precision_rounds_its_results_alone():
    draw = torch.Generator().manual_seed(5)
    plain, fused = quantizers(IntFormat(3), 0.3)
    v, grad = (torch.randn(4, 24, 9, 8, generator=draw).bfloat16() for _ in range(2))
    y, to_v, to_step = quantised(fused, v, grad)
    true_y, true_to_v, true_to_step = quantised(plain, v.float(), grad.float())
    assert (y.dtype, to_v.dtype, to_step.dtype) == (torch.bfloat16, torch.bfloat16, torch.float32)
    assert torch.equal(y, true_y.bfloat16())
    assert torch.equal(to_v, true_to_v.bfloat16())
    assert to_step.item() == pytest.approx(true_to_step.item(), rel=1e-4)


def test_a_quantiser_passes_on_what_is_no_number_and_holds_its_smallest_step():
    for layer in quantizers(IntFormat(3), -1.0):
        v = torch.tensor([float("nan"), 1.0, -1.0, 1e-9]).view(1, 1, 2, 2)
        y, to_v, to_step = quantised(layer, v, torch.ones_like(v))
        assert y.isnan().flatten().tolist() == [True, False, False, False]
        assert y.flatten()[1].item() == pytest.approx(7e-8)
        assert to_v.flatten().tolist() == [0, 0, 0, 1]
        assert to_step.isnan()


def test_a_quantisers_sum_does_not_depend_on_threads():
    v = torch.randn(8, 16, 60, 61, generator=torch.Generator().manual_seed(2))
    same_with_any_threads(lambda: quantised(quantizers(IntFormat(3), 0.3)[1], v, v.flip(0)))


def test_a_quantiser_of_values_without_gradient_and_of_one_gradient_for_all():
    plain, fused = quantizers(IntFormat(3), 0.3)
    v = torch.randn(2, 3, 4, 5, generator=torch.Generator().manual_seed(3)).transpose(2, 3)
    for layer in (plain, fused):
        layer(v).sum().backward()
    assert fused.step.grad.item() == pytest.approx(plain.step.grad.item(), rel=1e-5)


def test_other_quantisers_go_pytorchs_way():
    weights = LsqQuantizer(IntFormat(3), batched=False)
    per_channel = LsqQuantizer(IntFormat(3), step_shape=(4, 1, 1, 1), batched=False)
    fuse_quantizers(nn.ModuleList([weights, per_channel]))
    assert type(weights) is type(per_channel) is LsqQuantizer
    plain, fused = quantizers(IntFormat(3), 0.3)
    seen = []
    fused.observer = lambda layer, v: seen.append(layer)
    v = torch.randn(2, 3, 4, 4, generator=torch.Generator().manual_seed(1))
    assert fused(v) is v
    fused.observer = None
    assert seen == [fused]
    with torch.no_grad():
        assert torch.equal(fused(v), plain(v))
    assert torch.equal(fused(v[0]), plain(v[0]))
    assert torch.equal(fused.to_codes(v), plain.to_codes(v))


# ---- views ------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def frames(tmp_path_factory):
    root = tmp_path_factory.mktemp("scene")
    write_scene(root / "data")
    return pack_frames(DataSettings(str(root / "data"), cache=str(root / "cache")), "training", filled=False)


def views_of(frames, seed, augment, size):
    cells = Cells(LEVELS, size, CPU)
    return cells, draw_views(
        frames, np.arange(24) % len(frames), np.random.default_rng(seed), augment, size=size,
        anchors=LEVELS.anchors, cells=len(cells), noise_places=Warper.noise_places(size),
    )  # fmt: skip


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize(
    ("augment", "size"),
    [
        (AugmentSettings(gamma=2.0, exposure=2.0, noise=9.0), (64, 64)),
        (AugmentSettings(gamma=1.0, exposure=1.0, noise=0.0, shift=0.9), (64, 64)),
        (AugmentSettings(centred=True, scale=0.4, gamma=3.0), (96, 32)),
    ],
)
def test_views_in_one_pass_are_the_same_pictures(frames, seed, augment, size):
    cells, views = views_of(frames, seed, augment, size)
    warper = Warper(frames, CPU, 0, counterfactual=False)
    assert warper.in_one_pass
    fast = warper.batch(views, cells, size)
    warper.in_one_pass = False
    slow = warper.batch(views, cells, size)
    assert fast.image.is_contiguous(memory_format=torch.channels_last)
    assert fast.erased is None
    levels = ((fast.image - slow.image) * (255 * torch.tensor(IMAGENET_STD).reshape(3, 1, 1))).abs()
    assert levels.max() < 1.01  # where a half is rounded the other way
    assert (levels > 1e-3).float().mean() < 1e-4
    assert slow.inside.any()
    for mine, true in zip(fast[2:], slow[2:], strict=True):
        assert torch.equal(mine, true)


def test_frames_that_do_not_exist_are_not_read(frames):
    _, views = views_of(frames, 0, AugmentSettings(), (64, 64))
    views.frame[3] = len(frames)
    image = torch.empty((24, 3, 64, 64), memory_format=torch.channels_last)
    with pytest.raises(ValueError, match="cannot be read"):
        draw_pictures(frames.pixels, views, torch.zeros(64), NOISE_STRIDE, image)


# ---- the compiler -----------------------------------------------------------------------------------


@pytest.fixture
def elsewhere(tmp_path, monkeypatch):
    """An empty cache, and nothing remembered."""
    monkeypatch.setenv("MACRAM_BUILD_DIR", str(tmp_path / "build"))
    compiled.library.cache_clear()
    yield tmp_path / "build/native"
    compiled.library.cache_clear()


def test_compiled_once(elsewhere):
    assert compiled.library("pictures") is not None
    (made,) = elsewhere.iterdir()
    written = made.stat().st_mtime_ns
    compiled.library.cache_clear()
    assert compiled.library("pictures") is not None
    assert [(path, path.stat().st_mtime_ns) for path in elsewhere.iterdir()] == [(made, written)]


def test_a_damaged_library_is_compiled_again(elsewhere):
    made = elsewhere / f"pictures-{compiled._key(compiled.SOURCES / 'pictures.cpp')}.so"
    elsewhere.mkdir(parents=True)
    made.write_bytes(b"")
    assert compiled.library("pictures") is not None
    assert made.stat().st_size > 0


@pytest.mark.parametrize("fault", ["missing", "failing", "folder"])
def test_without_a_compiler_pytorch_does_the_work(elsewhere, monkeypatch, tmp_path, fault, frames):
    tools = tmp_path / "tools"
    tools.mkdir()
    monkeypatch.setenv("PATH", str(tools))
    if fault == "failing":
        (tools / "g++").write_text('#!/bin/sh\nfor last; do :; done\necho half of it > "$last"\nexit 1\n')
        (tools / "g++").chmod(0o755)
    if fault == "folder":
        elsewhere.parent.write_text("a file where the folder should be")
    assert compiled.library("norm_relu") is None
    layer = nn.BatchNorm2d(64)
    fuse_batch_norm(layer)
    assert type(layer) is nn.BatchNorm2d
    quantizer = LsqQuantizer(IntFormat(3), batched=True)
    fuse_quantizers(quantizer)
    assert type(quantizer) is LsqQuantizer
    cells, views = views_of(frames, 0, AugmentSettings(), (64, 64))
    warper = Warper(frames, CPU, 0, counterfactual=False)
    assert not warper.in_one_pass
    assert warper.batch(views, cells, (64, 64)).image.isfinite().all()
    if fault != "folder":
        assert not list(elsewhere.iterdir())


def test_numbers_reach_compiled_code_as_what_they_are(monkeypatch):
    taken = []
    monkeypatch.setattr(
        compiled, "library", lambda name: {"lib": SimpleNamespace(f=lambda *a: taken.extend(a))}[name]
    )
    tensor, array = torch.zeros(3), np.zeros(3, np.uint8)
    compiled.call("lib", "f", 3, np.int64(1 << 40), 0.5, np.float32(0.25), None, tensor, array)
    assert [value.value for value in taken[:5]] == [3, 1 << 40, 0.5, 0.25, None]
    kinds = [ctypes.c_int64, ctypes.c_int64, ctypes.c_double, ctypes.c_double, ctypes.c_void_p]
    assert [type(value) for value in taken[:5]] == kinds
    assert [value.value for value in taken[5:]] == [tensor.data_ptr(), array.ctypes.data]
    for wrong in ("3", np.bool_(True), [1]):
        with pytest.raises(TypeError, match="f takes tensors, arrays and numbers"):
            compiled.call("lib", "f", wrong)


# ---- memory -----------------------------------------------------------------------------------------

HELD = """
import ctypes, re
from macram.train.memory import keep_memory
keep_memory()
libc = ctypes.CDLL(None)
libc.malloc.restype = ctypes.c_void_p
size = 64 << 20

def resident():
    return int(re.search(r"VmRSS:\\s+(\\d+)", open("/proc/self/status").read())[1]) << 10

assert resident() < 1 << 28  # reserved, not taken
block = libc.malloc(ctypes.c_size_t(size))
ctypes.memset(block, 1, size)
for region in re.split(r"\\n(?=[0-9a-f]+-)", open("/proc/self/smaps").read()):
    start, end = (int(value, 16) for value in region.split(maxsplit=1)[0].split("-"))
    if start <= block + (1 << 22) < end:
        print(region)
before = resident()
libc.free(ctypes.c_void_p(block))
assert resident() > before - (1 << 24)  # freed memory stays
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="asks Linux")
def test_heap_keeps_its_memory_in_large_pages():
    told = subprocess.run([sys.executable, "-c", HELD], check=True, capture_output=True, text=True).stdout
    assert "[heap]" in told
    assert " hg" in told.split("VmFlags:")[1]  # advised: huge pages
