#include "apps/proof/laws/point_text.h"

namespace gnomon::laws {

void write(std::ostream& out, const char* what, std::span<const Point3> points) {
  out << what << ":";
  for (const Point3& p : points) out << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  out << "\n";
}

void write(std::ostream& out, const char* what, std::span<const Point2> points) {
  out << what << ":";
  for (const Point2& p : points) out << " {" << p.x << ", " << p.y << "}";
  out << "\n";
}

}  // namespace gnomon::laws
