#include "shading/image/shaded_image.h"

#include <cmath>

#include "geometry/parallel.h"
#include "gnomon/errors.h"
#include "shading/image/camera.h"
#include "shading/image/facet_shading.h"
#include "shading/reflection/bounded.h"

namespace gnomon::image {
namespace {

using shading::Bounded;

/// Of a light's own surface: its radiance.
Shaded shining(const SceneLight& light) {
  Shaded result;
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = light.strength * light.color[c];
    result.radiance[c] = {value, value == light.strength ? 0 : 0x1p-52 * value};
  }
  return result;
}

/// The means of what several rays see.
class PixelMean {
 public:
  void add(const Shaded& shaded) {
    for (std::size_t c = 0; c < 3; ++c) {
      radiance_[c] = radiance_[c] + Bounded(shaded.radiance[c].value, shaded.radiance[c].error_bound);
    }
    irradiance_ = irradiance_ + Bounded(shaded.irradiance.value, shaded.irradiance.error_bound);
  }
  void put_into(ImagePixel& pixel, double count) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const Irradiance mean = over(radiance_[c], count);
      pixel.radiance[c] = {mean.value, mean.error_bound};
    }
    pixel.irradiance = over(irradiance_, count);
  }

 private:
  static Irradiance over(const Bounded& sum, double count) {
    if (shading::is_exact_zero(sum)) return {};
    const double value = sum.value / count;
    return {value, shading::with_underflow(1.01 * (sum.error / count + shading::unit * value))};
  }

  std::array<Bounded, 3> radiance_;
  Bounded irradiance_;
};

double distance_to(const Point3& eye, const Point3& p) {
  return std::hypot(p.x - eye.x, p.y - eye.y, p.z - eye.z);
}

class Painter {
 public:
  Painter(const SpaceScene& scene, const ImageOptions& options)
      : camera_(*scene.camera),
        surfaces_(surfaces_of(scene)),
        shaded_{scene, PreparedObstacles(scene_bodies(scene).obstacles), {}, scene.camera->eye},
        hits_(surfaces_.facets),
        shading_(shaded_, surfaces_.facets, options.shading),
        samples_(options.samples) {
    for (const SceneLight& light : scene.lights) shaded_.lights.push_back(&light);
    for (unsigned t = 0; t < thread_count(options.threads); ++t) {
      lights_.emplace_back();
      for (const SceneLight& light : scene.lights) lights_.back().emplace_back(light, shaded_.obstacles, options);
    }
  }

  ImagePixel pixel(std::uint32_t i, std::uint32_t j, std::size_t worker) {
    ImagePixel pixel;
    PixelMean mean;
    const std::optional<Hit> middle = hits_.along(camera_.ray(i + 0.5, j + 0.5));
    pixel.depth = middle ? distance_to(shaded_.eye, middle->place) : HUGE_VAL;
    if (middle) {
      pixel.element = static_cast<std::int32_t>(surfaces_.facets[middle->facet].element);
      pixel.facet = static_cast<std::int32_t>(surfaces_.facets[middle->facet].number);
    }
    const bool has_one = samples_ == 1;
    for (std::uint32_t b = 0; b < samples_; ++b) {
      for (std::uint32_t a = 0; a < samples_; ++a) {
        const double x = i + (a + 0.5) / samples_, y = j + (b + 0.5) / samples_;
        const std::optional<Hit> hit = has_one ? middle : hits_.along(camera_.ray(x, y));
        if (hit) mean.add(seen(*hit, lights_[worker]));
      }
    }
    mean.put_into(pixel, double(samples_) * samples_);
    return pixel;
  }

  std::size_t workers() const { return lights_.size(); }
  void count_answers(ShadedImage& image) const {
    for (const WorkersLights& own : lights_) {
      for (const LightSource& light : own) {
        image.answers += light.answers();
        image.exact_answers += light.exact_answers();
      }
    }
  }
  const Surfaces& surfaces() const { return surfaces_; }

 private:
  Shaded seen(const Hit& hit, WorkersLights& lights) {
    const Facet& facet = surfaces_.facets[hit.facet];
    return facet.light ? shining(*facet.light) : shading_.at(hit, lights);
  }

  Camera camera_;
  Surfaces surfaces_;
  ShadedScene shaded_;
  FirstHit hits_;
  FacetShading shading_;
  std::uint32_t samples_;
  std::vector<WorkersLights> lights_;
};

}  // namespace

ShadedImage shaded_image(const SpaceScene& scene, const ImageOptions& options,
                         const std::function<void(std::size_t pixels)>& on_progress) {
  if (!scene.camera) throw PreconditionError("a picture needs a camera");
  Painter painter(scene, options);
  ShadedImage image{
      scene.camera->width, scene.camera->height, painter.surfaces().elements, painter.surfaces().lights_from, {}};
  image.pixels.resize(std::size_t{image.width} * image.height);
  constexpr std::size_t block = 64;  // pixels
  const std::size_t blocks = (image.pixels.size() + block - 1) / block;
  for_all(blocks, static_cast<unsigned>(painter.workers()), [&](std::size_t b, std::size_t worker) {
    const std::size_t end = std::min((b + 1) * block, image.pixels.size());
    for (std::size_t k = b * block; k < end; ++k) {
      const auto i = static_cast<std::uint32_t>(k % image.width), j = static_cast<std::uint32_t>(k / image.width);
      image.pixels[k] = painter.pixel(i, j, worker);
    }
    on_progress(end - b * block);
  });
  const std::size_t more = options.samples == 1 ? 0 : std::size_t{options.samples} * options.samples;
  image.rays = image.pixels.size() * (1 + more);
  image.flattened = painter.surfaces().flattened;
  painter.count_answers(image);
  return image;
}

}  // namespace gnomon::image
