#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Boost 1.74 (Debian libboost1.74-dev 1.74.0+ds1-21).
# Expected: a quotient or root computed with fifty decimal digits and converted to double is the nearest
# double, which is what the processor computes.
# Seen: some of 10,000 are off in the last bit, with a hundred digits as many. It is the conversion of
# cpp_dec_float: the same numbers printed and read again by strtod() are right, and cpp_bin_float is.
# Met: reference values with many digits, against which tests compare the last bits.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libboost1.74-dev=1.74.0+ds1-21 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >rounding.cpp <<'CPP'
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/version.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

template <typename Number>
void tell(const char* name)
{
  std::mt19937_64 bits(1);
  const auto random = [&] { return 1 + std::ldexp(double(bits() >> 12), -52); };
  int quotients = 0, roots = 0, printed = 0;
  for(int i = 0; i < 10000; ++i) {
    const double a = random(), b = random();
    const Number quotient = Number(a) / Number(b);
    quotients += static_cast<double>(quotient) != a / b;
    roots += static_cast<double>(sqrt(Number(a))) != std::sqrt(a);
    printed += std::strtod(quotient.str().c_str(), nullptr) != a / b;
  }
  std::printf("%s: %d quotients and %d roots differ; printed and read, %d quotients\n", name, quotients, roots, printed);
}

int main()
{
  std::printf("Boost %d.%d\n", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000);
  tell<boost::multiprecision::cpp_bin_float_50>("cpp_bin_float_50");
  tell<boost::multiprecision::cpp_dec_float_50>("cpp_dec_float_50");
  tell<boost::multiprecision::cpp_dec_float_100>("cpp_dec_float_100");
}
CPP
cat >wanted <<'TEXT'
Boost 1.74
cpp_bin_float_50: 0 quotients and 0 roots differ; printed and read, 0 quotients
cpp_dec_float_50: 9 quotients and 12 roots differ; printed and read, 0 quotients
cpp_dec_float_100: 9 quotients and 12 roots differ; printed and read, 0 quotients
TEXT

g++ -std=c++17 -w -O1 -I root/usr/include rounding.cpp -o rounding
./rounding | tee seen
diff wanted seen
