"""Quotas against the published table, the draw of positive cells, and the surface head's targets."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from macram.model import SPEED_LEVELS, Levels
from macram.pose import level_quota
from macram.train.targets import (
    cells_in_mask,
    draw_batch_labels,
    draw_labels,
    surface_targets,
    target_size,
)

TABLE = {
    25: (8, 2, 0, 0, 0),
    32: (7, 3, 0, 0, 0),
    45: (5, 5, 1, 0, 0),
    64: (2, 6, 2, 0, 0),
    90: (1, 4, 4, 1, 0),
    128: (0, 2, 6, 2, 0),
    181: (0, 1, 4, 4, 1),
    256: (0, 0, 2, 6, 2),
    300: (0, 0, 1, 5, 3),
    512: (0, 0, 0, 3, 7),
}
LEVELS = Levels()


def generator(seed=0):
    return torch.Generator().manual_seed(seed)


@pytest.mark.parametrize("size", TABLE)
def test_quotas_are_the_published_ones(size):
    assert tuple(level_quota(size, LEVELS.anchors)) == TABLE[size]


def test_target_size_is_the_longer_side_plus_one():
    assert target_size(torch.tensor([[10.0, 20.0], [40.0, 25.0], [12.0, 90.0]])) == 71.0


def test_centre_pixels_decide():
    mask = torch.zeros(64, 64, dtype=torch.bool)
    mask[4, 12] = True  # the centre of cell (row 0, column 1) at stride 8
    cells = cells_in_mask(mask, 8, (8, 8))
    assert cells.nonzero().tolist() == [[0, 1]]
    assert not cells_in_mask(mask, 16, (4, 4)).any()


def test_a_centre_beyond_a_small_crop_counts_as_its_border():
    mask = torch.zeros(64, 64, dtype=torch.bool)
    mask[63, 63] = True
    assert cells_in_mask(mask, 256, (1, 1)).all()


def square(low, high, side=512):
    mask = torch.zeros(side, side, dtype=torch.bool)
    mask[low:high, low:high] = True
    keypoints = torch.tensor([[low, low], [high - 1, high - 1]], dtype=torch.float32)
    return mask, keypoints


def test_quota_positive_rest_ignored_outside_background():
    mask, keypoints = square(128, 256)  # 128 px: quotas 0 2 6 2 0
    labels = draw_labels(mask, keypoints, LEVELS, generator())
    assert [tuple(level.shape) for level in labels] == [(s, s) for s in (64, 32, 16, 8, 4)]
    assert [int((level == 1).sum()) for level in labels] == [0, 2, 6, 2, 0]
    for level, stride in zip(labels, LEVELS.strides, strict=True):
        inside = cells_in_mask(mask, stride, tuple(level.shape))
        assert torch.equal(level != 0, inside)
    assert [int((level == -1).sum()) for level in labels] == [256, 62, 10, 2, 1]


def test_fewer_candidates_than_quota_are_all_positive():
    mask, keypoints = square(128, 256)
    mask[:, 160:] = False  # 32 columns stay: 8 cells of stride 32 at most
    labels = draw_labels(mask, keypoints, LEVELS, generator())
    assert int((labels[2] == 1).sum()) == 4
    assert int((labels[2] == -1).sum()) == 0


def test_an_empty_mask_is_all_background():
    mask, keypoints = square(128, 256)
    assert all(not level.any() for level in draw_labels(mask & False, keypoints, LEVELS, generator()))


def test_the_generator_alone_decides_and_draws_uniformly():
    mask, keypoints = square(128, 256)
    torch.manual_seed(0)
    one = draw_labels(mask, keypoints, LEVELS, generator(3))
    same = draw_labels(mask, keypoints, LEVELS, generator(3))
    assert all(torch.equal(a, b) for a, b in zip(one, same, strict=True))
    counts = torch.zeros(16, 16)
    source = generator(9)
    for _ in range(400):
        counts += draw_labels(mask, keypoints, LEVELS, source)[2] == 1
    drawn = counts[4:8, 4:8]
    assert counts.sum() == drawn.sum() == 2400
    assert 110 < drawn.min() <= drawn.max() < 190  # 150 expected, deviation 9.7


def test_a_batch_is_its_pictures_and_speed_maps_fit():
    mask, keypoints = square(300, 700, 960)
    labels = draw_batch_labels(
        torch.stack([mask, mask & False]), torch.stack([keypoints, keypoints]), SPEED_LEVELS, generator()
    )
    assert [tuple(level.shape) for level in labels] == [(2, 1, s, s) for s in (120, 60, 30, 15, 8)]
    quotas = level_quota(400.0, SPEED_LEVELS.anchors)
    assert [int((level[0] == 1).sum()) for level in labels] == list(quotas)
    assert all(not level[1].any() for level in labels)


LOW, HIGH = torch.tensor([-50.0, -40.0, -60.0]), torch.tensor([50.0, 40.0, 60.0])
CAMERA = torch.tensor([[300.0, 0, 256], [0, 300.0, 256], [0, 0, 1]])


def test_surface_of_a_box_seen_head_on():
    pixels = torch.tensor([[256.0, 256.0], [256 + 300 * 25 / 440, 256.0], [500.0, 256.0]])
    faces, points = surface_targets(pixels, torch.eye(3), torch.tensor([0.0, 0.0, 500.0]), CAMERA, LOW, HIGH)
    assert faces.tolist() == [4, 4, -1]  # the low z side is the near one
    wanted = torch.tensor([[0, 0, -1], [0.5, 0, -1], [0, 0, 0]], dtype=torch.float32)
    torch.testing.assert_close(points, wanted, atol=1e-5, rtol=0)


@pytest.mark.parametrize("seed", [2, 3, 4])
def test_surface_points_lie_on_the_ray_and_on_the_named_face(seed):
    rng = np.random.default_rng(seed)
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    rotation = torch.from_numpy(q * np.sign(np.linalg.det(q))).float()
    translation = torch.tensor([15.0, -10.0, 420.0])
    low, high = LOW + torch.tensor([5.0, 0, 0]), HIGH
    pixels = torch.from_numpy(rng.uniform(200, 312, (200, 2))).float()
    faces, points = surface_targets(pixels, rotation, translation, CAMERA, low, high)
    hit = faces >= 0
    assert 50 < hit.sum() < 200
    object_points = points * (high - low) / 2 + (high + low) / 2
    camera = object_points @ rotation.T + translation
    projected = (camera @ CAMERA.T)[:, :2] / camera[:, 2:]
    torch.testing.assert_close(projected[hit], pixels[hit], atol=0.02, rtol=0)
    axis, side = faces[hit] // 2, faces[hit] % 2
    torch.testing.assert_close(points[hit].gather(1, axis[:, None])[:, 0], 2.0 * side - 1, atol=1e-4, rtol=0)
    # The entered face looks towards the camera.
    normal = torch.zeros(int(hit.sum()), 3)
    normal[torch.arange(len(axis)), axis] = 2.0 * side - 1
    assert (((normal @ rotation.T) * camera[hit]).sum(1) < 0).all()
    assert len(faces[hit].unique()) >= 2
