from __future__ import annotations

from dataclasses import fields, replace

import cv2
import numpy as np
import pytest
import torch
from train_scene import CORNERS, DIAMETER, write_scene

from macram.data.erase import grow
from macram.front.image import IMAGENET_MEAN, IMAGENET_STD
from macram.model import Levels, Prediction
from macram.model.anchors import decode, map_sizes
from macram.pose import Pose, project
from macram.pose.warp import Draw, Warp, exact_warp, warp_image, warp_mask
from macram.train.augment import NONE, AugmentSettings
from macram.train.losses import LossWeights, focal_loss, object_space_loss
from macram.train.objective import PER_IMAGES, SLOTS, Objective, assign, positive_slots
from macram.train.pack import cache_root, pack_frames
from macram.train.settings import DataSettings
from macram.train.targets import IGNORED, POSITIVE, cells_in_mask, sight
from macram.train.views import _moves as moves
from macram.train.views import draw_views, frame_order
from macram.train.warp import Batch, Cells, Warper

LEVELS = Levels()
CPU = torch.device("cpu")


@pytest.fixture(scope="module")
def settings(tmp_path_factory):
    root = tmp_path_factory.mktemp("scene")
    write_scene(root / "data")
    return DataSettings(str(root / "data"), cache=str(root / "cache"))


@pytest.fixture(scope="module")
def frames(settings):
    return pack_frames(settings, "training", filled=False)


def views_of(frames, seed, augment=None, size=(64, 64), count=8):
    cells = Cells(LEVELS, size, CPU)
    chosen = np.arange(count) % len(frames)
    rng = np.random.default_rng(seed)
    augment = AugmentSettings() if augment is None else augment
    places = Warper.noise_places(size)
    return (
        draw_views(
            frames,
            chosen,
            rng,
            augment,
            size=size,
            anchors=LEVELS.anchors,
            cells=len(cells),
            noise_places=places,
        ),
        cells,
    )


def test_views_larger_than_the_noise_are_refused():
    assert Warper.noise_places((1182, 1182)) == 46
    with pytest.raises(ValueError, match=r"views of 1920x1216 pixels are too large.*data\.shrink"):
        Warper.noise_places((1216, 1920))


# ---- packing ----------------------------------------------------------------------------------------


def test_packed_frames_are_the_decoded_ones(settings, frames):
    from pathlib import Path  # noqa: PLC0415

    from macram.data.open import open_dataset  # noqa: PLC0415

    assert frames.pixels.shape == (8, 64, 64, 4)
    for index, frame in enumerate(open_dataset(Path(settings.root)).frames("training")):
        assert (frames.pixels[index, ..., :3] == frame.read_image()).all()
        assert ((frames.pixels[index, ..., 3] > 0) == frame.read_mask()).all()
        assert frames.mask_pixels[index] == frame.read_mask().sum()
        inside = frames.mask_points[index].astype(int)
        assert frame.read_mask()[inside[:, 1], inside[:, 0]].all()


def test_positives_keep_to_the_hull_of_the_keypoints(settings, tmp_path):
    """An antenna far outside the box is in the mask, is erased, and teaches no pose."""
    root = write_scene(tmp_path / "data", counts=(8, 1))
    places = []
    for path in sorted((root / "training/seq_000000/000000/mask_visib").iterdir()):
        mask = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        antenna = np.zeros_like(mask)
        antenna[2:7, 30:62] = 255
        antenna[mask > 0] = 0
        cv2.imwrite(str(path), mask | antenna)
        places.append((mask > 0, antenna > 0))
    cells = Cells(LEVELS, (64, 64), CPU)
    chosen = np.arange(8)
    inside = {}
    for positives in ("mask", "hull"):
        new = replace(settings, root=str(root), cache=str(tmp_path / "cache"), positives=positives)
        packed = pack_frames(new, "training", filled=False)
        for index, (body, antenna) in enumerate(places):
            alpha = packed.pixels[index, ..., 3]
            assert (alpha[antenna] == (128 if positives == "hull" else 255)).all()
            assert (alpha[body] == 255).mean() > 0.85  # the rim of a drawn polygon lies outside
            assert not alpha[~(body | antenna)].any()
        views = draw_views(
            packed, chosen, np.random.default_rng(0), NONE, size=(64, 64), anchors=LEVELS.anchors,
            cells=len(cells), noise_places=Warper.noise_places((64, 64)),
        )  # fmt: skip
        warper = Warper(packed, CPU, 0, counterfactual=True)
        inside[positives] = warper.batch(views, cells, (64, 64))
    at = torch.floor(cells.sampled).long()
    for index, (_, antenna) in enumerate(places):
        on_antenna = torch.from_numpy(antenna)[at[:, 1], at[:, 0]]
        assert on_antenna.any()
        assert inside["mask"].inside[index][on_antenna].all()
        assert not inside["hull"].inside[index][on_antenna].any()
    assert inside["hull"].inside.any(dim=1).all()
    assert torch.equal(inside["mask"].erased, inside["hull"].erased)


def test_second_packing_reads_the_cache_and_a_changed_file_does_not(settings, tmp_path):
    root = write_scene(tmp_path / "data", (3, 1))
    mine = DataSettings(str(root), cache=str(tmp_path / "cache"))
    told = []
    pack_frames(mine, "training", filled=False, told=lambda done, total: told.append(done))
    pack_frames(mine, "training", filled=False, told=lambda done, total: told.append(done))
    assert told == [1, 2, 3]
    image = root / "training/seq_000000/000000/rgb/000001.png"
    image.write_bytes((root / "training/seq_000000/000000/rgb/000002.png").read_bytes())
    again = pack_frames(mine, "training", filled=False, told=lambda done, total: told.append(done))
    assert told == [1, 2, 3, 1, 2, 3]
    assert (again.pixels[1, ..., :3] == again.pixels[2, ..., :3]).all()


@pytest.mark.parametrize("kind", ["background", "inpaint"])
def test_filled_pictures(settings, kind):
    packed = pack_frames(replace(settings, counterfactual=kind), "training", filled=True)
    truth = np.linspace(20, 90, 64)
    assert np.abs(packed.filled.astype(float) - truth[None, None, :, None]).max() < (
        2 if kind == "background" else 60
    )
    far = grow(packed.pixels[0, ..., 3] > 0) == 0
    assert (packed.filled[0][far] == packed.pixels[0, ..., :3][far]).all()


@pytest.mark.parametrize(
    ("xdg", "cache", "folder"),
    [
        ("", "", "home/.cache/macram/frames"),
        ("relative", "", "home/.cache/macram/frames"),  # as the XDG specification wants it
        ("/xdg", "", "/xdg/macram/frames"),
        ("/xdg", "/mine", "/mine"),
    ],
)
def test_where_packed_frames_are_kept(xdg, cache, folder, tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("XDG_CACHE_HOME", xdg)
    assert cache_root(DataSettings("data", cache=cache)) == tmp_path / folder


def test_a_bad_picture_leaves_no_cache(tmp_path):
    root = write_scene(tmp_path / "data", (2, 1))
    (root / "training/seq_000000/000000/rgb/000001.png").write_bytes(b"no picture")
    with pytest.raises(ValueError, match=r"000001\.png"):
        pack_frames(DataSettings(str(root), cache=str(tmp_path / "cache")), "training", filled=False)
    assert not list((tmp_path / "cache").iterdir())


# ---- views ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("centred", [False, True])
def test_batch_of_moves_is_the_single_warp(frames, centred):
    rng = np.random.default_rng(5)
    draws = np.column_stack((rng.uniform(-3, 3, 8), rng.uniform(0.8, 1.2, 8), rng.integers(-6, 7, (8, 2))))
    batch = moves(frames, np.arange(8), draws, AugmentSettings(centred=centred), (96, 96))
    for n, (angle, zoom, x, y) in enumerate(draws):
        pose = Pose(frames.rotation[n], frames.translation[n])
        one = exact_warp(
            Draw(angle, zoom, (x, y)), frames.camera[n], frames.camera[n], (96, 96), pose, centred=centred
        )
        assert np.abs(batch.matrix[n] - one.matrix).max() < 1e-9
        assert np.abs(batch.camera[n] - one.K).max() < 1e-9
        assert np.abs(batch.rotation[n] - one.pose.R).max() < 1e-12
        assert np.abs(batch.translation[n] - one.pose.t[:, 0]).max() < 1e-9


@pytest.mark.parametrize("size", [(64, 64), (32, 32)])
def test_labels_follow_the_picture(frames, size):
    views, _ = views_of(frames, 1, AugmentSettings(centred=size != (64, 64)), size)
    for n in range(8):
        before = project(frames.camera[n], frames.rotation[n], frames.translation[n][:, None], CORNERS)
        moved = before @ views.matrix[n, :2, :2].T + views.matrix[n, :2, 2]
        assert np.abs(moved - views.pixels[n]).max() < 1e-9
        truth = project(views.camera[n], views.rotation[n], views.translation[n][:, None], CORNERS)
        assert np.abs(truth - views.pixels[n]).max() < 1e-9


def test_centred_views_hold_the_whole_target(frames):
    views, _ = views_of(frames, 2, AugmentSettings(shift=0.05, centred=True), (32, 32), 64)
    extent = np.ptp(views.pixels, axis=1).max(axis=1)
    assert extent.max() < 0.95 * 32
    assert ((views.pixels > -2) & (views.pixels < 34)).all()


def test_views_keep_the_target_in_sight(frames):
    _, cells = views_of(frames, 0)
    wild = AugmentSettings(shift=0.9, noise=0.0)
    views, cells = views_of(frames, 3, wild, count=64)
    batch = Warper(frames, CPU, 0, counterfactual=False).batch(views, cells, (64, 64))
    for n in range(64):
        warp = Warp(views.matrix[n], views.camera[n], Pose(views.rotation[n], views.translation[n]), (64, 64))
        mask = frames.pixels[views.frame[n], ..., 3] > 0
        assert warp_mask(mask, warp).sum() >= 5  # 10 by the estimate
    assert batch.image.shape == (64, 3, 64, 64)


def test_parts_do_not_depend_on_the_number_of_processes(frames):
    whole, _ = views_of(frames, 4)
    parts = [whole.part(rank, 3) for rank in range(3)]
    for field in fields(whole):
        joined = np.concatenate([getattr(part, field.name) for part in parts])
        assert (joined == getattr(whole, field.name)).all()


def test_every_epoch_visits_every_frame_once():
    order = frame_order(7, 10, 0, 30)
    assert all(sorted(order[i : i + 10]) == list(range(10)) for i in (0, 10, 20))
    assert (frame_order(7, 10, 13, 9) == order[13:22]).all()
    assert (order[:10] != order[10:20]).any()
    assert (frame_order(8, 10, 0, 30) != order).any()


# ---- pictures ---------------------------------------------------------------------------------------


def pixels_of(tensor):
    mean, std = (np.array(v)[:, None, None] * 255 for v in (IMAGENET_MEAN, IMAGENET_STD))
    return tensor.numpy() * std + mean


def test_plain_views_are_the_frames(frames):
    views, cells = views_of(frames, 0, NONE)
    batch = Warper(frames, CPU, 0, counterfactual=True).batch(views, cells, (64, 64))
    for n in range(8):
        image = frames.pixels[n, ..., :3].transpose(2, 0, 1)
        assert np.abs(pixels_of(batch.image[n]) - image).max() < 1e-3
        erased = np.where(grow(frames.pixels[n, ..., 3] > 0), 0, image)
        assert np.abs(pixels_of(batch.erased[n]) - erased).max() < 1e-3


@pytest.mark.parametrize("size", [(64, 64), (96, 96)])
def test_warp_agrees_with_opencv(frames, size):
    plain = AugmentSettings(gamma=1.0, exposure=1.0, noise=0.0, centred=size != (64, 64))
    views, cells = views_of(frames, 6, plain, size)
    batch = Warper(frames, CPU, 0, counterfactual=False).batch(views, cells, size)
    for n in range(8):
        warp = Warp(views.matrix[n], views.camera[n], Pose(views.rotation[n], views.translation[n]), size)
        want = warp_image(np.ascontiguousarray(frames.pixels[n, ..., :3]), warp).transpose(2, 0, 1)
        # OpenCV interpolates at 1/32 pixel: a few levels at edges.
        error = np.abs(pixels_of(batch.image[n]) - want)
        assert np.quantile(error, 0.9) <= 2
        assert error.mean() < 1
        mask = torch.from_numpy(warp_mask(frames.pixels[n, ..., 3] > 0, warp))
        inside = [
            cells_in_mask(mask, s, m).flatten() for s, m in zip(LEVELS.strides, map_sizes(*size), strict=True)
        ]
        assert (torch.cat(inside) != batch.inside[n]).float().mean() < 0.02


def test_quarter_turn_is_exact(frames):
    views, cells = views_of(frames, 0, NONE)
    matrix = np.tile([[0.0, -1, 64], [1, 0, 0], [0, 0, 1]], (8, 1, 1))
    turned = replace(views, matrix=matrix, other=matrix)
    batch = Warper(frames, CPU, 0, counterfactual=False).batch(turned, cells, (64, 64))
    want = np.rot90(frames.pixels[0, ..., :3], -1).transpose(2, 0, 1)
    assert np.abs(pixels_of(batch.image[0]) - want).max() < 0.6


def test_tone_and_noise(frames):
    views, cells = views_of(frames, 0, NONE)
    tone = np.tile([2.0, 0.5, 0.0], (8, 1))
    image = (
        Warper(frames, CPU, 0, counterfactual=False).batch(replace(views, tone=tone), cells, (64, 64)).image
    )
    want = np.rint(127.5 * (frames.pixels[0, ..., :3].transpose(2, 0, 1) / 255) ** 2)
    assert np.abs(pixels_of(image[0]) - want).max() < 0.01 + 1  # a half may round either way
    tone = np.tile([1.0, 1.0, 3.0], (8, 1))
    noisy = (
        Warper(frames, CPU, 0, counterfactual=False).batch(replace(views, tone=tone), cells, (64, 64)).image
    )
    noise = pixels_of(noisy[0]) - frames.pixels[0, ..., :3].transpose(2, 0, 1)
    assert noise.std() == pytest.approx(3.0, rel=0.05)
    assert (views.noise[0] != views.noise[1]) or (noise != 0).any()


def test_independent_draws_move_the_counterfactual_picture(frames):
    shared, _cells = views_of(frames, 9)
    apart, _ = views_of(frames, 9, AugmentSettings(draws="independent"))
    assert (shared.other == shared.matrix).all()
    assert (apart.other != apart.matrix).any()


# ---- targets and losses -----------------------------------------------------------------------------


def test_assignment_draws_the_quota_inside(frames):
    views, cells = views_of(frames, 11, count=32)
    batch = Warper(frames, CPU, 0, counterfactual=False).batch(views, cells, (64, 64))
    labels = assign(batch, cells)
    start = 0
    for level, count in enumerate(cells.counts):
        mine, inside = labels[:, start : start + count], batch.inside[:, start : start + count]
        positive = (mine == POSITIVE).sum(1)
        assert (positive == torch.minimum(inside.sum(1), batch.quota[:, level])).all()
        assert (inside[mine == POSITIVE]).all()
        assert ((mine == 0) == ~inside).all()
        assert ((mine == IGNORED) == (inside & (mine != POSITIVE))).all()
        start += count
    other = assign(batch._replace(keys=1 - batch.keys), cells)
    assert (other != labels).any()


def test_slots_hold_every_positive_cell():
    labels = torch.zeros(3, 50, dtype=torch.int8)
    labels[1, [4, 9, 49]] = POSITIVE
    labels[2, 10 : 10 + SLOTS] = POSITIVE
    slots, valid = positive_slots(labels)
    assert valid.sum(1).tolist() == [0, 3, SLOTS]
    assert slots[1][valid[1]].tolist() == [4, 9, 49]
    assert slots[2].tolist() == list(range(10, 10 + SLOTS))


def test_losses_equal_the_plain_sums(frames):
    views, cells = views_of(frames, 12)
    batch = Warper(frames, CPU, 0, counterfactual=False).batch(views, cells, (64, 64))
    generator = torch.Generator().manual_seed(0)
    predictions = tuple(
        Prediction(
            torch.randn(8, 1, *m, generator=generator),
            torch.randn(8, 16, *m, generator=generator),
            torch.randn(8, 9, *m, generator=generator),
        )
        for m in map_sizes(64, 64)
    )
    weights = LossWeights(classes=0.7, pose=1.3, surface=0.2, pose_scale=200.0)
    objective = Objective(weights, DIAMETER, torch.from_numpy(CORNERS))
    got = objective.factual(predictions, batch, cells, 8, surface=True)

    labels = assign(batch, cells)
    start, classes, pose = 0, 0.0, 0.0
    for level, prediction in enumerate(predictions):
        n = cells.counts[level]
        mine = labels[:, start : start + n].reshape(prediction.logits.shape)
        classes += focal_loss(prediction.logits, mine)
        image, _, row, column = (mine == POSITIVE).nonzero(as_tuple=True)
        pixels = decode(prediction.offsets, level, LEVELS)[image, row, column]
        pose += object_space_loss(pixels, batch.points[image], batch.camera[image], DIAMETER, 200.0)
        start += n
    assert PER_IMAGES == 8
    assert float(got["class"]) == pytest.approx(0.7 * float(classes), rel=1e-5)
    assert float(got["pose"]) == pytest.approx(1.3 * float(pose), rel=1e-4)
    assert float(got["surface"]) > 0
    # Twice the images in the whole batch: half the weight each.
    half = objective.factual(predictions, batch, cells, 16, surface=True)
    assert all(float(half[name]) == pytest.approx(float(got[name]) / 2) for name in got)


def test_lines_of_sight_follow_from_the_inverse_camera():
    camera = torch.tensor([[300.0, 7, 120], [0, 290, 90], [0, 0, 1]], dtype=torch.float64)
    pixels = torch.rand(5, 2, dtype=torch.float64) * 200
    rays = torch.nn.functional.pad(pixels, (0, 1), value=1.0) @ torch.linalg.inv(camera).T
    assert torch.allclose(sight(pixels, camera), rays, atol=1e-12)


def test_perfect_predictions_cost_nothing(frames):
    views, cells = views_of(frames, 13)
    batch = Warper(frames, CPU, 0, counterfactual=False).batch(views, cells, (64, 64))
    offsets = (batch.pixels[:, None] - cells.centres[:, None]) / cells.anchors[
        :, None, None
    ]  # [B, cells, K, 2]
    rows = offsets.permute(0, 3, 2, 1).flatten(1, 2)
    logits = torch.where(batch.inside, 20.0, -20.0)
    predictions, start = [], 0
    for n, m in zip(cells.counts, map_sizes(64, 64), strict=True):
        part = slice(start, start + n)
        predictions.append(
            Prediction(logits[:, None, part].reshape(8, 1, *m), rows[:, :, part].reshape(8, 16, *m))
        )
        start += n
    losses = Objective(LossWeights(), DIAMETER, torch.from_numpy(CORNERS)).factual(
        predictions, batch, cells, 8, surface=False
    )
    assert float(losses["pose"]) < 1e-6
    assert float(losses["class"]) < 1e-6
    assert isinstance(batch, Batch)


@pytest.mark.parametrize(
    ("part", "name"), [("mask_visib", "000003_000000.png"), ("background", "000003.jpg")]
)
def test_a_picture_of_another_size_beside_the_frame_is_named(part, name, tmp_path):
    folder = write_scene(tmp_path / "scene") / "training/seq_000000/000000" / part
    cv2.imwrite(str(folder / name), np.zeros((32, 32, 3), np.uint8))
    settings = DataSettings(
        str(tmp_path / "scene"), cache=str(tmp_path / "cache"), counterfactual="background"
    )
    with pytest.raises(ValueError, match=f"{name}: 32x32 pixels, but others have 64x64"):
        pack_frames(settings, "training", filled=True)
    assert not any((tmp_path / "cache").iterdir())
