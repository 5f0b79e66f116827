"""The losses on cases worked out by hand, and their gradients."""

from __future__ import annotations

import math

import numpy as np
import pytest
import torch

from macram.train.losses import (
    focal_loss,
    imitation_loss,
    object_space_loss,
    similarity_loss,
    surface_loss,
)

K = torch.tensor([[300.0, 0, 256], [0, 300.0, 256], [0, 0, 1]])


def logit(p):
    return math.log(p / (1 - p))


def test_focal_loss_of_three_cells_by_hand():
    logits = torch.tensor([logit(0.8), logit(0.3), logit(0.9)])
    labels = torch.tensor([1, 0, -1])
    wanted = -0.25 * 0.2**2 * math.log(0.8) - 0.75 * 0.3**2 * math.log(0.7)
    assert focal_loss(logits, labels).item() == pytest.approx(wanted, rel=1e-5)


def test_focal_loss_sums_and_ignored_cells_have_no_gradient():
    logits = torch.zeros(2, 1, 3, 3, requires_grad=True)
    labels = torch.zeros(2, 1, 3, 3, dtype=torch.int8)
    labels[0, 0, 0] = -1
    loss = focal_loss(logits, labels)
    assert loss.item() == pytest.approx(15 * 0.75 * 0.25 * math.log(2), rel=1e-5)
    loss.backward()
    assert (logits.grad[0, 0, 0] == 0).all()
    assert (logits.grad[1] > 0).all()


@pytest.mark.parametrize(("label", "value"), [(1, -100.0), (0, 100.0)])
def test_focal_loss_is_bounded_by_the_probability_floor(label, value):
    loss = focal_loss(torch.tensor([value]), torch.tensor([label])).item()
    weight = 0.25 if label else 0.75
    assert loss == pytest.approx(weight * (1 - 1e-6) ** 2 * -math.log(1e-6), rel=0.01)


def test_focal_loss_refuses_labels_of_another_shape():
    with pytest.raises(ValueError, match=r"labels must be \[2\], not \[3\]"):
        focal_loss(torch.zeros(2), torch.zeros(3))


def test_pose_loss_of_one_point_on_the_axis_by_hand():
    # P = (0, 0, 1000), predicted 3 px to the right: b = (0.01, 0, 1), foot = b * 1000 / 1.0001.
    points = torch.tensor([[[0.0, 0.0, 1000.0]]])
    pixels = torch.tensor([[[259.0, 256.0]]])
    dx, dz = 10 / 1.0001, 1000 / 1.0001 - 1000
    d = 178.46

    def huber(e):
        e = abs(50 * e / d)
        return (0.5 * e * e if e < 1 else e - 0.5) / 50

    assert huber(dx) > 0.5 / 50  # beyond the knee, which lies at d / 50 = 3.57 mm
    wanted = (huber(dx) + 0 + huber(dz)) / 3
    assert object_space_loss(pixels, points, K, d).item() == pytest.approx(wanted, rel=1e-3)


def test_pose_loss_against_a_second_writing_in_numpy():
    rng = np.random.default_rng(5)
    m, k = 4, 8
    points = rng.normal([20, -30, 700], 50, (m, k, 3))
    cameras = np.repeat(K.numpy()[None].astype(float), m, 0)
    cameras[:, 0, 0] = cameras[:, 1, 1] = rng.uniform(250, 350, m)
    pixels = (points @ cameras.transpose(0, 2, 1)) / points[..., 2:]
    pixels = pixels[..., :2] + rng.normal(0, 4, (m, k, 2))
    total = 0.0
    for cell in range(m):
        terms = []
        for point, (u, v) in zip(points[cell], pixels[cell], strict=True):
            b = np.linalg.inv(cameras[cell]) @ [u, v, 1]
            foot = np.outer(b, b) @ point / (b @ b)
            e = np.abs(50 * (foot - point) / 178.46)
            terms.append(np.where(e < 1, 0.5 * e**2, e - 0.5) / 50)
        total += np.mean(terms)
    arguments = (torch.from_numpy(a) for a in (pixels, points, cameras))
    assert object_space_loss(*arguments, 178.46).item() == pytest.approx(total, rel=1e-4)


def test_pose_loss_is_zero_on_target_and_falls_towards_it():
    points = torch.tensor([[[30.0, -20.0, 500.0], [0.0, 40.0, 600.0]]])
    exact = (points @ K.T)[..., :2] / points[..., 2:]
    assert object_space_loss(exact, points, K, 178.46).item() == pytest.approx(0, abs=1e-9)
    pixels = (exact + 2.0).requires_grad_()
    object_space_loss(pixels, points, K, 178.46).backward()
    assert (pixels.grad > 0).all()


def test_pose_loss_without_positive_cells_is_zero_and_differentiable():
    pixels = torch.zeros(0, 8, 2, requires_grad=True)
    loss = object_space_loss(pixels, torch.zeros(0, 8, 3), torch.zeros(0, 3, 3), 178.46)
    assert loss.item() == 0
    loss.backward()
    assert pixels.grad.shape == (0, 8, 2)


def test_pose_loss_refuses_shapes_that_do_not_agree():
    with pytest.raises(ValueError, match="pixels must be"):
        object_space_loss(torch.zeros(2, 8, 2), torch.zeros(2, 11, 3), K, 1.0)


def test_similarity_by_hand_and_only_the_pseudo_side_learns():
    pseudo = [torch.tensor([[[[0.5, 3.0]]]], requires_grad=True), torch.zeros(1, 1, 1, 1, requires_grad=True)]
    goal = [torch.zeros(1, 1, 1, 2, requires_grad=True), torch.full((1, 1, 1, 1), 0.2)]
    loss = similarity_loss(tuple(pseudo), tuple(goal))
    assert loss.item() == pytest.approx((0.125 + 2.5) / 2 + 0.02)
    loss.backward()
    assert pseudo[0].grad is not None
    assert goal[0].grad is None


def test_imitation_by_hand_and_only_the_student_learns():
    # One picture, two channels, two cells of which the second is on the target; then a level without any.
    student = torch.tensor([[[[1.0, 2.0]], [[0.0, 1.0]]]], requires_grad=True)
    teacher = torch.tensor([[[[1.0, 0.0]], [[2.0, 1.0]]]], requires_grad=True)
    above = torch.full((1, 2, 1, 1), 3.0), torch.full((1, 2, 1, 1), 4.0)
    on = [torch.tensor([[False, True]]), torch.tensor([[False]])]
    loss = imitation_loss((student, above[0]), (teacher, above[1]), on)
    wanted = (8 / 6 + 4 / 1 + 2 / 32 + 0) / 4
    assert loss.item() == pytest.approx(wanted, rel=1e-6)
    loss.backward()
    assert teacher.grad is None
    assert student.grad[0, :, 0, 0].tolist() == pytest.approx([0, 2 * -2 / 6 / 4])
    assert student.grad[0, :, 0, 1].tolist() == pytest.approx([2 * 2 * (1 / 6 + 1) / 4, 0])


def test_imitation_is_a_sum_over_pictures_whatever_their_scale():
    generator = torch.Generator().manual_seed(3)
    maps = torch.randn((2, 3, 4, 2, 5), generator=generator)
    student, teacher = maps[0].clone(), maps[1].clone()
    on = torch.rand((3, 10), generator=generator) < 0.4
    whole = imitation_loss([student], [teacher], [on]).item()
    parts = [imitation_loss([student[i : i + 1]], [teacher[i : i + 1]], [on[i : i + 1]]) for i in range(3)]
    assert whole == pytest.approx(sum(part.item() for part in parts), rel=1e-5)
    assert imitation_loss([100 * student], [100 * teacher], [on]).item() == pytest.approx(whole, rel=1e-5)
    assert imitation_loss([teacher], [teacher], [on]).item() == 0
    assert imitation_loss([0 * teacher], [teacher], [on]).item() == pytest.approx(3, rel=1e-5)


def test_what_a_teacher_leaves_at_zero_is_not_imitated():
    # As P6 and P7 of a network whose pyramids share their top.
    on = [torch.ones(2, 4, dtype=torch.bool)]
    student = torch.ones(2, 3, 2, 2, requires_grad=True)
    loss = imitation_loss([student], [torch.zeros(2, 3, 2, 2)], on)
    loss.backward()
    assert loss.item() == 0
    assert not student.grad.any()


def test_surface_loss_by_hand_and_misses_do_not_count():
    outputs = torch.zeros(2, 9)
    outputs[0, 6:] = torch.tensor([0.5, 0.0, -1.0])
    faces = torch.tensor([3, -1])
    loss = surface_loss(outputs, faces, torch.zeros(2, 3)).item()
    assert loss == pytest.approx(math.log(6) + 1.5)
    assert surface_loss(outputs, torch.tensor([-1, -1]), torch.zeros(2, 3)).item() == 0
