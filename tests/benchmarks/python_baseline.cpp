// What Python is measured against: the irradiance of points by the library itself, on one thread.
//
//   python_baseline SCENE POINTS
//
// POINTS holds doubles, x y z nx ny nz of each point. Prints the seconds for all of them, the microseconds of one
// question, the first point's, asked over and over, and the sum of the irradiances.

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "gnomon/irradiance.h"
#include "gnomon/scene.h"

namespace {

using gnomon::Irradiance, gnomon::LightIrradiance, gnomon::Point3;

struct Sensor {
  Point3 point, normal;
};

std::vector<Sensor> sensors_in(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  std::vector<Sensor> sensors(bytes.size() / sizeof(Sensor));
  bytes.copy(reinterpret_cast<char*>(sensors.data()), sensors.size() * sizeof(Sensor));
  return sensors;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class Asked {
 public:
  explicit Asked(const gnomon::SpaceScene& scene)
      : scene_(scene),
        unit_(*gnomon::length_unit_named(scene.length_unit)),
        obstacles_(gnomon::scene_bodies(scene).obstacles) {
    for (const auto& light : scene.lights) lights_.emplace_back(light.shape, light.strength, obstacles_);
  }

  void at(const Sensor& sensor, Irradiance* answers) {
    const gnomon::ReceiverPoint receiver = resting_point(obstacles_, sensor.point, sensor.normal);
    for (std::size_t l = 0; l < lights_.size(); ++l) {
      answers[l] = per_square_metre(lights_[l].received(receiver, sensor.normal), scene_.lights[l].shape, unit_);
    }
  }

  std::size_t light_count() const { return lights_.size(); }

 private:
  const gnomon::SpaceScene& scene_;
  gnomon::LengthUnit unit_;
  gnomon::PreparedObstacles obstacles_;
  std::vector<LightIrradiance> lights_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const gnomon::Scene read = gnomon::read_scene(argv[1]);
  const std::vector<Sensor> sensors = sensors_in(argv[2]);
  if (sensors.empty()) return 3;
  Asked asked(std::get<gnomon::SpaceScene>(read));
  const std::size_t lights = asked.light_count();
  std::vector<Irradiance> answers(sensors.size() * lights);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < sensors.size(); ++i) asked.at(sensors[i], &answers[i * lights]);
  const double all = seconds_since(start);
  double sum = 0;
  for (const Irradiance& e : answers) sum += e.value;
  constexpr int calls = 200000;
  const auto again = std::chrono::steady_clock::now();
  for (int k = 0; k < calls; ++k) asked.at(sensors.front(), answers.data());
  std::printf("%.9g %.9g %.17g\n", all, seconds_since(again) / calls * 1e6, sum);
}
