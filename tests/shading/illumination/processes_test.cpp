#include "gnomon/processes.h"

#include <gtest/gtest.h>

#include <barrier>
#include <cstring>
#include <functional>
#include <thread>

#include "geometry/shared_work.h"
#include "gnomon/illumination.h"
#include "gnomon/view_factors.h"
#include "tests/shading/illumination/factor_oracles.h"

namespace gnomon {
namespace {

/// Processes that are threads of this one.
class Together {
 public:
  explicit Together(std::uint32_t count) : texts_(count), meeting_(count) {}

  /// Runs a task as each of them; what they throw, or nothing, by number.
  std::vector<std::string> run(const std::function<void(const Processes&)>& task) {
    std::vector<std::string> thrown(texts_.size());
    std::vector<std::thread> threads;
    for (std::uint32_t number = 0; number < texts_.size(); ++number) {
      threads.emplace_back([&, number] {
        try {
          task(process(number));
        } catch (const std::exception& error) {
          thrown[number] = error.what();
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    return thrown;
  }

 private:
  Processes process(std::uint32_t number) {
    return {number, static_cast<std::uint32_t>(texts_.size()), [this, number](const std::string& mine) {
              texts_[number] = mine;
              meeting_.arrive_and_wait();
              const std::vector<std::string> all = texts_;
              meeting_.arrive_and_wait();
              return all;
            }};
  }

  std::vector<std::string> texts_;
  std::barrier<> meeting_;
};

/// A room with a box, lit from its ceiling.
struct Room {
  std::vector<ViewSurface> walls = factors::cube_walls(1);
  std::vector<ConvexBlocker> box;
  Room() { factors::add_box(walls, box, {.25, .375, .125}, {.5, .625, .75}); }
};

std::vector<ConvexPolygon> receivers_of(const Room& room) {
  std::vector<ConvexPolygon> receivers;
  for (const ViewSurface& wall : room.walls) receivers.insert(receivers.end(), wall.begin(), wall.end());
  return receivers;
}

bool same_factors(const ViewFactors& a, const ViewFactors& b) {
  const auto same = [](const ViewFactor& p, const ViewFactor& q) {
    return p.from == q.from && p.to == q.to && p.value == q.value && p.error_bound == q.error_bound &&
           p.is_proven == q.is_proven;
  };
  return a.evaluations == b.evaluations && a.divided_pairs == b.divided_pairs &&
         std::ranges::equal(a.factors, b.factors, same);
}

bool same_meshes(const Illumination& a, const Illumination& b) {
  const auto same_values = [](const Irradiance& p, const Irradiance& q) {
    return p.value == q.value && p.error_bound == q.error_bound;
  };
  const auto same = [&](const IlluminationMesh& p, const IlluminationMesh& q) {
    return p.order == q.order && p.points == q.points && std::ranges::equal(p.irradiance, q.irradiance, same_values) &&
           p.of_lights.size() == q.of_lights.size() &&
           std::ranges::equal(p.of_lights[0], q.of_lights[0], same_values) &&
           std::ranges::equal(p.faces, q.faces,
                              [](const IlluminationFace& f, const IlluminationFace& g) {
                                return f.corners == g.corners && f.middles == g.middles && f.error == g.error;
                              }) &&
           p.edges.size() == q.edges.size();
  };
  return a.tolerance == b.tolerance && a.largest == b.largest && a.evaluations == b.evaluations &&
         std::ranges::equal(a.meshes, b.meshes, same);
}

TEST(Processes, OfAnyNumberFindTheViewFactorsThatOneFinds) {
  const Room room;
  ViewFactorEffort effort;
  effort.bound = 1e-5;
  const ViewFactors alone = view_factors(room.walls, {room.box, {}}, effort);
  ASSERT_GT(alone.divided_pairs, 0U);
  for (const std::uint32_t count : {2U, 3U, 40U}) {
    const auto thrown = Together(count).run([&](const Processes& processes) {
      ViewFactorEffort own = effort;
      own.processes = processes;
      EXPECT_TRUE(same_factors(view_factors(room.walls, {room.box, {}}, own), alone)) << count;
    });
    for (const std::string& words : thrown) EXPECT_EQ(words, "");
  }
}

TEST(Processes, OfAnyNumberMakeTheMeshesThatOneMakes) {
  const Room room;
  const std::vector<ConvexPolygon> receivers = receivers_of(room);
  const IlluminationLight lamp{
      {AreaLight{ConvexPolygon::from_points({{.25, .25, .875}, {.25, .5, .875}, {.5, .5, .875}, {.5, .25, .875}})}}, 1};
  for (const int order : {1, 2}) {
    IlluminationEffort effort;
    effort.tolerance = 0.05;
    effort.order = order;
    const Illumination alone = illuminate({&lamp, 1}, {room.box, {}}, receivers, effort);
    for (const std::uint32_t count : {2U, 5U}) {
      const auto thrown = Together(count).run([&](const Processes& processes) {
        IlluminationEffort own = effort;
        own.processes = processes;
        EXPECT_TRUE(same_meshes(illuminate({&lamp, 1}, {room.box, {}}, receivers, own), alone)) << count;
      });
      for (const std::string& words : thrown) EXPECT_EQ(words, "");
    }
  }
}

TEST(Processes, AllFailWithTheWordsOfTheOneThatFails) {
  const auto thrown = Together(3).run([](const Processes& processes) {
    std::vector<std::vector<double>> results(4);
    share_results<double>(processes, results, [&] {
      if (processes.number == 1) throw std::runtime_error("no memory for receiver 'floor'");
    });
  });
  for (const std::string& words : thrown) EXPECT_EQ(words, "process 1 of 3 failed: no memory for receiver 'floor'");
}

TEST(Processes, RefuseScenesThatDiffer) {
  const Room room;
  const auto thrown = Together(2).run([&](const Processes& processes) {
    ViewFactorEffort effort;
    effort.processes = processes;
    std::vector<ViewSurface> walls = room.walls;
    if (processes.number == 1) walls.pop_back();
    view_factors(walls, {room.box, {}}, effort);
  });
  for (const std::string& words : thrown) EXPECT_NE(words.find("different scenes"), std::string::npos) << words;
}

TEST(Processes, ToldLessThanAnnouncedRefuseIt) {
  std::string bytes;
  append_bytes(bytes, std::vector<double>{1, 2, 3});
  std::string_view whole = bytes;
  EXPECT_EQ(take_values<double>(whole), (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(whole.empty());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::string_view part(bytes.data(), size);
    EXPECT_ANY_THROW(take_values<double>(part)) << size;
  }
  const std::size_t huge = ~std::size_t{0};
  std::memcpy(bytes.data(), &huge, sizeof huge);
  std::string_view announced = bytes;
  EXPECT_ANY_THROW(take_values<double>(announced));
}

}  // namespace
}  // namespace gnomon
