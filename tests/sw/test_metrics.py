from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.data.geometry import BOX_EDGES
from macram.pose import Pose, add, adi, box_corners, proj, project, re, sample_vertices, speed_score, te
from macram.pose import evaluation as ev
from macram.pose import score as speed
from macram.pose.rigid import camera_matrix, roll

K = np.array([[303.787, 0.0, 256.0], [0.0, 303.787, 256.0], [0.0, 0.0, 1.0]])
POINTS = np.random.default_rng(5).uniform(-50, 50, (137, 3))
D = 178.43


def quaternion_matrix(q):
    w, x, y, z = np.asarray(q) / np.linalg.norm(q)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def random_pose(rng, near=1.5, far=10.0):
    z = rng.uniform(near, far) * D
    return Pose(quaternion_matrix(rng.normal(size=4)), [0.2 * z, -0.1 * z, z])


def about(axis, angle):
    q = np.zeros(4)
    q[0], q[1 + axis] = np.cos(angle / 2), np.sin(angle / 2)
    return quaternion_matrix(q)


# ---- single errors ----------------------------------------------------------------------------------


def test_identity_has_no_error():
    pose = random_pose(np.random.default_rng(0))
    both = (pose.R, pose.t, pose.R, pose.t)
    assert add(*both, POINTS) == adi(*both, POINTS) == proj(*both, K, POINTS) == 0.0
    assert te(pose.t, pose.t) == 0.0
    assert re(pose.R, pose.R) < 1e-13


@pytest.mark.parametrize("shift", [(3.0, -4.0, 12.0), (0.0, 0.0, -7.0)])
def test_translation_moves_every_point_by_its_length(shift):
    pose = random_pose(np.random.default_rng(1))
    moved = pose.t + np.reshape(shift, (3, 1))
    length = np.linalg.norm(shift)
    assert add(pose.R, moved, pose.R, pose.t, POINTS) == pytest.approx(length, rel=1e-12)
    assert te(moved, pose.t) == pytest.approx(length, rel=1e-12)
    assert re(pose.R, pose.R) < 1e-13


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("angle", [1e-7, 0.01, 1.0, 2.5, np.pi - 1e-7, np.pi])
def test_known_angle(axis, angle):
    pose = random_pose(np.random.default_rng(2))
    turned = about(axis, angle) @ pose.R
    assert re(turned, pose.R) == pytest.approx(np.degrees(angle), rel=1e-9)
    assert re(pose.R, turned) == pytest.approx(np.degrees(angle), rel=1e-9)
    # A point at distance r from the axis moves by the chord 2 r sin(angle / 2).
    radius = np.linalg.norm(np.delete(POINTS @ pose.R.T, axis, axis=1), axis=1)
    chord = (2 * radius * np.sin(angle / 2)).mean()
    assert add(turned, pose.t, pose.R, pose.t, POINTS) == pytest.approx(chord, rel=1e-8)


@settings(deadline=None, max_examples=50)
@given(st.integers(0, 2**32 - 1))
def test_angle_equals_the_quaternion_formula(seed):
    a, b = np.random.default_rng(seed).normal(size=(2, 4))
    dot = abs(a @ b) / np.linalg.norm(a) / np.linalg.norm(b)
    expected = 2 * np.arccos(min(1.0, dot))
    assert speed.e_q(quaternion_matrix(a), quaternion_matrix(b)) == pytest.approx(expected, abs=1e-7)


def test_scalar_first_quaternion_turns_x_to_y():
    np.testing.assert_allclose(quaternion_matrix([1, 0, 0, 1]) @ [1, 0, 0], [0, 1, 0], atol=1e-15)
    np.testing.assert_allclose(roll(np.pi / 2) @ [1, 0, 0], [0, 1, 0], atol=1e-15)


def test_symmetric_object_separates_add_and_adi():
    # A square turned by a quarter falls onto itself: every corner moves along a side of length 2.
    square = np.array([[-1.0, -1, 0], [-1, 1, 0], [1, -1, 0], [1, 1, 0]])
    t = np.array([[0.0], [0.0], [10.0]])
    quarter = roll(np.pi / 2)
    assert add(quarter, t, np.eye(3), t, square) == pytest.approx(2.0, rel=1e-12)
    assert adi(quarter, t, np.eye(3), t, square) == pytest.approx(0.0, abs=1e-12)
    # An eighth does not: the nearest turned corner of (1, 1) is (0, sqrt 2) or (sqrt 2, 0).
    eighth = roll(np.pi / 4)
    chord = 2 * np.sqrt(2) * np.sin(np.pi / 8)
    assert adi(eighth, t, np.eye(3), t, square) == pytest.approx(chord, rel=1e-12)
    assert add(eighth, t, np.eye(3), t, square) == pytest.approx(chord, rel=1e-12)


@pytest.mark.parametrize("count", [1, 63, 64, 65, 200])
def test_adi_equals_the_full_table_of_distances(count):
    rng = np.random.default_rng(count)
    points = rng.uniform(-50, 50, (count, 3))
    a, b = random_pose(rng, 2, 2.2), random_pose(rng, 2, 2.2)
    estimated, true = points @ a.R.T + a.t.T, points @ b.R.T + b.t.T
    table = np.linalg.norm(true[:, None] - estimated[None], axis=2)
    assert adi(a.R, a.t, b.R, b.t, points) == pytest.approx(table.min(axis=1).mean(), rel=1e-12)
    # Nearest ESTIMATED point of each true one, not the other way round.
    if count == 200:
        assert table.min(axis=1).mean() != pytest.approx(table.min(axis=0).mean(), rel=1e-6)


def test_reprojection_of_a_sideways_step():
    t = np.array([[0.0], [0.0], [1000.0]])
    flat = POINTS * [1, 1, 0]
    moved = np.array([[10.0], [0.0], [1000.0]])
    expected = 303.787 * 10 / 1000
    assert proj(np.eye(3), moved, np.eye(3), t, K, flat) == pytest.approx(expected, rel=1e-12)


def test_a_point_behind_the_camera_has_no_pixel():
    assert np.isnan(project(K, np.eye(3), [[0], [0], [10.0]], [[0, 0, -10.0], [0, 0, -9]])[0]).all()
    assert np.isnan(proj(np.eye(3), [[0], [0], [-900.0]], np.eye(3), [[0], [0], [900.0]], K, POINTS))


@pytest.mark.parametrize("lead", [(1,), (7,), (2, 3)])
def test_batched_equals_single(lead):
    rng = np.random.default_rng(11)
    count = int(np.prod(lead))
    poses = [(random_pose(rng), random_pose(rng)) for _ in range(count)]
    stack = [np.stack([getattr(p[i], n) for p in poses]) for i in (0, 1) for n in ("R", "t")]
    r_est, t_est, r_gt, t_gt = (a.reshape(*lead, *a.shape[1:]) for a in stack)
    singles = [(a.R, a.t, b.R, b.t) for a, b in poses]
    cases = [
        (add(r_est, t_est, r_gt, t_gt, POINTS), [add(*p, POINTS) for p in singles]),
        (adi(r_est, t_est, r_gt, t_gt, POINTS), [adi(*p, POINTS) for p in singles]),
        (proj(r_est, t_est, r_gt, t_gt, K, POINTS), [proj(*p, K, POINTS) for p in singles]),
        (re(r_est, r_gt), [re(p[0], p[2]) for p in singles]),
        (te(t_est, t_gt), [te(p[1], p[3]) for p in singles]),
        (speed.e_q(r_est, r_gt), [speed.e_q(p[0], p[2]) for p in singles]),
        (speed.e_t(t_est, t_gt), [speed.e_t(p[1], p[3]) for p in singles]),
    ]
    for batched, single in cases:
        assert batched.shape == lead
        np.testing.assert_allclose(batched.ravel(), single, rtol=1e-12)


def test_adi_broadcasts_one_truth_over_many_estimates():
    rng = np.random.default_rng(4)
    truth, guesses = random_pose(rng), [random_pose(rng) for _ in range(3)]
    many = adi(np.stack([g.R for g in guesses]), np.stack([g.t for g in guesses]), truth.R, truth.t, POINTS)
    np.testing.assert_allclose(many, [adi(g.R, g.t, truth.R, truth.t, POINTS) for g in guesses], rtol=1e-12)


# ---- SPEED ------------------------------------------------------------------------------------------


def test_speed_errors_in_closed_form():
    assert speed.e_t([[0], [0], [11.0]], [[0], [0], [10.0]]) == pytest.approx(0.1)
    assert speed.e_q(about(1, 0.25), np.eye(3)) == pytest.approx(0.25)
    with pytest.raises(ValueError, match="translation of zero"):
        speed.e_t([[1], [0], [0.0]], np.zeros((3, 1)))


def test_misses_are_counted_unless_the_published_convention_is_asked_for():
    e_q, e_t, found = [0.1, np.nan, 0.3, 0.2], [0.01, np.nan, 0.03, 2000.0], [True, False, True, True]
    counted = speed_score(e_q, e_t, found)
    assert counted.counted == 4
    assert counted.e_q == pytest.approx((0.1 + np.pi + 0.3 + 0.2) / 4)
    assert counted.e_t == pytest.approx((0.01 + 1 + 0.03 + 2000) / 4)
    assert counted.score == pytest.approx(counted.e_q + counted.e_t)
    skipped = speed_score(e_q, e_t, found, misses="skip")
    assert (skipped.counted, skipped.skipped) == (2, 2)
    assert skipped.score == pytest.approx(0.2 + 0.02)


def test_speed_score_without_any_answer():
    assert speed_score([np.nan], [np.nan], [False], misses="skip").score is None
    assert speed_score([np.nan], [np.nan], [False]).score == pytest.approx(np.pi + 1)
    with pytest.raises(ValueError, match="one length"):
        speed_score([1.0], [1.0, 2.0], [True])
    with pytest.raises(ValueError, match="'drop'"):
        speed_score([1.0], [1.0], [True], misses="drop")


# ---- depth ranges -----------------------------------------------------------------------------------


def test_fixed_limits():
    z = np.array([0.99, 1.0, 3.999, 4.0, 6.999, 7.0, 9.999, 10.0, 10.01]) * 2.0
    assert ev.fixed_buckets(z, 2.0).tolist() == [-1, 0, 0, 1, 1, 2, 2, 2, -1]
    for diameter in (178.46, 178.43, 0.1, 1 / 3):
        limits = np.array([1, 4, 7, 10]) * diameter
        assert ev.fixed_buckets(limits, diameter).tolist() == [0, 1, 2, 2]


def test_thirds_of_the_set_itself():
    z = np.array([30.0, 300.0, 100.0, 119.9, 120.1, 209.9, 210.1])
    assert ev.third_buckets(z).tolist() == [0, 2, 0, 0, 1, 1, 2]
    np.testing.assert_allclose(ev.third_limits(z), [30, 120, 210, 300], rtol=1e-6)
    assert ev.third_buckets([5.0, 5.0]).tolist() == [0, 0]
    # Over 1d to 10d the two divisions coincide.
    z = np.linspace(1, 10, 1001)
    assert np.count_nonzero(ev.third_buckets(z) != ev.fixed_buckets(z, 1.0)) == 0


# ---- whole sets -------------------------------------------------------------------------------------


def frames_at(depths):
    return [ev.GroundTruth(f"{i:06d}", Pose(np.eye(3), [0, 0, z * D]), K) for i, z in enumerate(depths)]


def shifted(frame, share):
    """The truth moved sideways by ``share`` of the diameter: ADD is exactly that share."""
    return Pose(frame.pose.R, frame.pose.t + np.array([[share * D], [0], [0]]))


def run(frames, predictions):
    return ev.evaluate(predictions, frames, vertices=POINTS, diameter=D)


def test_shares_per_range_and_threshold():
    frames = frames_at([2, 3, 5, 6, 8, 9, 9.5, 12])
    shares = [0.04, 0.3, 0.08, 0.15, 0.6, None, 0.01, 0.09]
    predictions = {f.name: shifted(f, s) for f, s in zip(frames, shares, strict=True) if s is not None}
    result = run(frames, predictions)
    fixed = result.summary["fixed"]
    assert [fixed[n]["frames"] for n in ("near", "medium", "far", "all")] == [2, 2, 3, 8]
    assert [fixed[n]["misses"] for n in ("near", "medium", "far", "all")] == [0, 0, 1, 1]
    assert result.summary["outside"] == 1
    percent = {
        limit: [fixed[n]["add"][limit] for n in ("near", "medium", "far", "all")] for limit in ("0.1", "0.5")
    }
    assert percent["0.1"] == [50.0, 50.0, pytest.approx(100 / 3), 50.0]
    assert percent["0.5"] == [100.0, 100.0, pytest.approx(100 / 3), 75.0]
    assert fixed["all"]["add"]["0.05"] == 25.0
    assert fixed["all"]["add"]["0.2"] == 62.5
    # "All" is the share of all frames, not the mean of the ranges.
    assert fixed["all"]["add"]["0.1"] != pytest.approx(np.mean(percent["0.1"][:3]))
    thirds = result.summary["thirds"]
    assert [thirds[n]["frames"] for n in ("near", "medium", "far", "all")] == [3, 2, 3, 8]


def test_a_miss_counts_one_diameter_and_fifty_pixels():
    frames = frames_at([2, 3])
    result = run(frames, {"000000": None})
    for row in result.rows:
        assert (row["detected"], row["add_d"], row["adi_d"], row["proj_px"]) == (False, 1.0, 1.0, 50.0)
        assert [row[k] for k in ("re_deg", "te_mm", "e_q", "e_t")] == [None] * 4
    assert result.summary["misses"] == 2
    assert result.summary["fixed"]["all"]["add"] == {"0.05": 0.0, "0.1": 0.0, "0.2": 0.0, "0.5": 0.0}
    assert result.summary["fixed"]["far"]["add"]["0.1"] is None
    assert result.summary["fixed"]["far"]["re_deg_median"] is None
    assert result.summary["speed"]["skip"]["score"] is None
    assert result.summary["speed"]["count"]["score"] == pytest.approx(np.pi + 1)


def test_thresholds_are_strict():
    # d = 1 and an error of exactly 0.5: representable, and not below 0.5.
    frame = ev.GroundTruth("a", Pose(np.eye(3), [0, 0, 4.0]), K)
    pose = Pose(np.eye(3), [0.5, 0, 4.0])
    result = ev.evaluate({"a": pose}, [frame], vertices=[[0.0, 0, 0], [0.5, 0, 0]], diameter=1.0)
    assert result.rows[0]["add_d"] == 0.5
    assert result.summary["fixed"]["all"]["add"]["0.5"] == 0.0


def test_rows_equal_the_single_functions():
    rng = np.random.default_rng(21)
    frames = [ev.GroundTruth(f"f{i}", random_pose(rng), K) for i in range(300)]
    predictions = {f.name: random_pose(rng) for f in frames if rng.random() < 0.9}
    result = run(frames, predictions)
    assert [row["frame"] for row in result.rows] == [f.name for f in frames]
    assert 0 < result.summary["misses"] < 60
    for row, frame in zip(result.rows, frames, strict=True):
        pose = predictions.get(frame.name)
        if pose is None:
            continue
        four = (pose.R, pose.t, frame.pose.R, frame.pose.t)
        assert row["add_mm"] == pytest.approx(float(add(*four, POINTS)), rel=1e-12)
        assert row["adi_mm"] == pytest.approx(float(adi(*four, POINTS)), rel=1e-12)
        assert row["add_d"] == pytest.approx(row["add_mm"] / D)
        assert row["proj_px"] == pytest.approx(float(proj(*four, K, POINTS)), rel=1e-12)
        assert row["re_deg"] == pytest.approx(float(re(pose.R, frame.pose.R)), rel=1e-12)
        assert row["te_mm"] == pytest.approx(float(te(pose.t, frame.pose.t)), rel=1e-12)
        assert row["e_q"] == pytest.approx(np.radians(row["re_deg"]), rel=1e-12)


def test_a_pose_behind_the_camera_is_charged_in_the_picture_too():
    frames = frames_at([2])
    row = run(frames, {"000000": Pose(np.eye(3), [0, 0, -2 * D])}).rows[0]
    assert row["proj_px"] == 50.0
    assert row["add_d"] == pytest.approx(4.0)


def test_bad_sets_are_refused():
    frames = frames_at([2, 3])
    with pytest.raises(ValueError, match="no frames"):
        run([], {})
    with pytest.raises(ValueError, match="000000 is there twice"):
        run([frames[0], frames[0]], {})
    with pytest.raises(ValueError, match="1 predictions belong to no frame, the first is x"):
        run(frames, {"x": None})
    with pytest.raises(ValueError, match="diameter"):
        ev.evaluate({}, frames, vertices=POINTS, diameter=0)
    with pytest.raises(ValueError, match="vertices"):
        ev.evaluate({}, frames, vertices=np.zeros((0, 3)), diameter=D)
    with pytest.raises(ValueError, match="not in front"):
        ev.GroundTruth("a", Pose(np.eye(3), [0, 0, -1.0]), K)


# ---- poses, cameras, vertices -----------------------------------------------------------------------


def test_a_pose_takes_only_rotations():
    assert Pose(np.eye(3).tolist(), [1, 2, 3]).t.shape == (3, 1)
    with pytest.raises(ValueError, match="not a rotation"):
        Pose(1.01 * np.eye(3), [0, 0, 1])
    with pytest.raises(ValueError, match="not a rotation"):
        Pose(np.diag([1.0, 1.0, -1.0]), [0, 0, 1])
    with pytest.raises(ValueError, match="finite"):
        Pose(np.eye(3), [0, 0, np.nan])
    with pytest.raises(ValueError, match=r"\[3, 1\]"):
        Pose(np.eye(3), [0, 1])


@pytest.mark.parametrize("bad", [range(8), [0] * 9, [1, 0, 0, 0, 1, 0, 0, 0, 2], [np.nan] * 9])
def test_a_camera_matrix_is_checked(bad):
    with pytest.raises(ValueError, match="camera matrix"):
        camera_matrix(bad)


def test_box_corners_run_z_fastest():
    box = box_corners((-1, -2, -3), (1, 2, 3))
    assert box[0].tolist() == [-1, -2, -3]
    assert box[1].tolist() == [-1, -2, 3]
    assert box[2].tolist() == [-1, 2, -3]
    assert box[4].tolist() == [1, -2, -3]
    assert len(BOX_EDGES) == 12
    assert sorted(np.linalg.norm(box[a] - box[b]) for a, b in BOX_EDGES) == [2] * 4 + [4] * 4 + [6] * 4


def test_vertices_are_the_same_every_time():
    mesh = np.random.default_rng(0).normal(size=(5000, 3))
    drawn = sample_vertices(mesh)
    assert drawn.shape == (1000, 3)
    assert np.array_equal(drawn, sample_vertices(mesh))
    assert not np.array_equal(drawn, sample_vertices(mesh, seed=1))
    assert len(np.unique(drawn, axis=0)) < 1000
    assert np.array_equal(sample_vertices(mesh[:10]), mesh[:10])
    with pytest.raises(ValueError, match="vertices must be"):
        sample_vertices(np.zeros((4, 2)))
    with pytest.raises(ValueError, match="count is 0"):
        sample_vertices(mesh, 0)


def test_poses_need_no_torch():
    code = "import sys, macram.pose, macram.report.evaluation; sys.exit('torch' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
