// SPDX-License-Identifier: Apache-2.0
// Laws as sums and products, and the same laws with one or two changes: a term, factor, power or
// input is left out, has the wrong sign, or is replaced by another.
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
    given,    // an input, or a number that another function computes from the inputs
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
    itself,
    to_decimals,  // the node's number is how many
    to_digits,
    whole_part
  };
  struct Node {
    Op kind;
    double number = 0;  // of a sum or a product
    std::vector<Operand> parts = {};
    std::function<double(const catalogue::Arguments&)> get = {};  // a number; of a choice, a place
    Call called = Call::itself;
    std::string name = {};       // "U"; empty: the node is written out
    std::string_view unit = {};  // of an input
  };

  // A number of the law: the own number of a sum or product, a coefficient, or an exponent.
  struct Place {
    std::size_t node;
    int slot;  // the place of the part; −1: the node's own number
  };

  std::vector<Node> nodes;
  std::vector<std::size_t> results;  // places among the nodes; the law of later results is unknown

  // The numbers that are not 0, without 1 and −1 before a product, in the order of the nodes.
  std::vector<Place> places_of_numbers() const;
  double& number_at(const Place& place);
  double value(std::size_t place, const catalogue::Arguments& arguments) const;
  // A node as text: "1 − 0.61 e^(−0.73 k)", or its name, unless `is_inside`.
  std::string in_words(std::size_t place, bool is_inside = false) const;
  // A factor or a term of a node: "U^0.67", "− 0.61 e^(−0.73 k)".
  std::string factor_in_words(const Operand& part) const;
  std::string term_in_words(const Operand& part) const;
  // The node itself, and all nodes whose values depend on its value.
  std::vector<std::size_t> dependent_on(std::size_t place) const;
};

// A number of a law as text: "0.61", "3/4", "√2", "2π".
std::string number_in_words(double number);

// The law of a function as terms and factors. Empty: the law has another form, for example an
// integral or the root of an equation.
std::optional<Expression> law_expression(const catalogue::Function& function);

// The law with one or two changes: "no factor π, in π a²".
struct ChangedExpression {
  std::size_t changes;
  std::string text;
  std::function<double(const Question&, std::size_t place)> answer;
};
// The laws with 1 or 2 `changes` that give the wrong answers of the part. The caller checks that
// the right answers stay right. One of two changes may be a number that is solved for. This is not
// tried if all answers are off by one factor (`is_one_factor`), which almost any number can give.
std::vector<ChangedExpression> changed_expressions(const Part& part, std::size_t changes,
                                                   bool is_one_factor);

// The law with each usual single change that alters its value in the case of a wrong answer.
struct LawWithChange {
  Expression law;
  std::string text;
};
std::vector<LawWithChange> laws_with_one_change(const Part& part);

}  // namespace tribo::conformance
