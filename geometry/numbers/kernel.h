#pragma once

/// The CGAL kernels and number types of the project, named once. Only .cpp files and private headers include this one.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/boost_mp.h>

#include "gnomon/point.h"

namespace gnomon {

/// Decides signs of determinants of input points exactly; constructs nothing.
using InputKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Exact arithmetic for constructed points and measures.
/// Operations return expression templates: name the type of a result, never `auto`.
using Rational = boost::multiprecision::mpq_rational;
using Integer = boost::multiprecision::mpz_int;

/// Exact sums and products of doubles.
using ExactReal = CGAL::Mpzf;

inline Rational rational(const ExactReal& number) {
  Rational result;
  number.export_to_mpq_t(result.backend().data());
  return result;
}

/// Encloses a real number; valid while the rounding mode is protected.
using Interval = CGAL::Interval_nt<false>;

/// The input point as CGAL sees it.
inline InputKernel::Point_3 to_cgal(const Point3& p) {
  return {p.x, p.y, p.z};
}

}  // namespace gnomon
