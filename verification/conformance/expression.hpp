// SPDX-License-Identifier: Apache-2.0
// Laws as sums and products, and what becomes of them where one or two of their terms, factors,
// powers or inputs are left out, of the wrong sign, or others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/question.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

class Expression {
 public:
  using Get = double (*)(const catalogue::Arguments& arguments);
  enum class Op : std::uint8_t {
    given,    // an input, or a number that is computed from the inputs otherwise
    sum,      // number + Σ number·part
    product,  // number · Π part^number
    power,    // part^part
    call,     // a function of one part
    choice    // one of the parts
  };
  struct Operand {
    std::size_t of;     // a place among the nodes
    double number = 1;  // the coefficient of a term, or the exponent of a factor
  };
  enum class Call : std::uint8_t {
    exponential,
    power_of_ten,
    logarithm,
    decimal_logarithm,
    arc,
    arc_of_inverse,
    arc_in_degrees,
    tangent,
    error,
    error_complement,
    hyperbolic_tangent,
    size,
    itself
  };
  struct Node {
    Op kind;
    double number = 0;  // of a sum or a product
    std::vector<Operand> parts = {};
    std::function<double(const catalogue::Arguments&)> get = {};  // given; choice: which part
    Call called = Call::itself;
    std::string name = {};       // "U"; empty: it is written out
    std::string_view unit = {};  // of an input
  };

  // A number that the law has: a sum's or a product's own one, a coefficient, or an exponent.
  struct Place {
    std::size_t node;
    int slot;  // of the part; −1: the node's own
  };

  std::vector<Node> nodes;
  std::vector<std::size_t> results;  // places among the nodes; those beyond the end are unknown

  // Those that are not 0, in the order of the nodes; a product has its own one where it is not 1.
  std::vector<Place> places_of_numbers() const;
  double& number_at(const Place& place);
  double value(std::size_t place, const catalogue::Arguments& arguments) const;
  // "1 − 0.61 e^(−0.73 k)"; a node with a name by this, unless it is asked for `inside`.
  std::string in_words(std::size_t place, bool is_inside = false) const;
  // A factor or a term of a node: "U^0.67", "− 0.61 e^(−0.73 k)".
  std::string factor_in_words(const Operand& part) const;
  std::string term_in_words(const Operand& part) const;
  // The node itself, and all nodes whose values depend on its value.
  std::vector<std::size_t> dependent_on(std::size_t place) const;
};

// The law of a function by its terms and factors; empty: it is no such expression, as an integral
// or a root is none.
std::optional<Expression> law_expression(const catalogue::Function& function);

// The law with one or two changes: "no factor π, in π a²".
struct ChangedExpression {
  std::size_t changes;
  std::string text;
  std::function<double(const Question&, std::size_t place)> answer;
};
// Those of so many changes, 1 or 2, that give the wrong answers of the part; the caller looks
// whether the right answers stay right. One of two may be a number that is solved for, but not
// where all answers are off by one factor, as any number makes one.
std::vector<ChangedExpression> changed_expressions(const Part& part, std::size_t changes,
                                                   bool is_one_factor);

// The law with each single change that people make and that the wrong answers of the part show.
struct LawWithChange {
  Expression law;
  std::string text;
};
std::vector<LawWithChange> laws_with_one_change(const Part& part);

}  // namespace tribo::conformance
