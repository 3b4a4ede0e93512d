{-# LANGUAGE GADTs #-}

-- | This library as an implementation under test.
module PraTactile.Conformance.Library
  ( library,
  )
where

import PraTactile.Conformance.Answer
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Library.Prepared
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Polynomial (PolynomialError (OrderNotFactored))
import PraTactile.Profile

-- | The library itself.
library :: Implementation
library =
  Implementation
    { implementationName = "pra-tactile",
      offered = allOperations,
      open = \p ->
        either (refuse . unopened) pure (withProfile p (\array -> opened . prepared p array)),
      withoutProfile = answering $ \question -> case question of
        op :? input -> case operationWays (recordOf op) of
          WithoutProfile _ ours -> ours input
          ByScene _ ours -> ours input
          UnderProfile _ _ -> notOffered
        Raw _ _ -> notOffered
    }
  where
    opened it = answering $ \question -> case question of
      op :? input -> case operationWays (recordOf op) of
        UnderProfile _ ours -> ours it input
        _ -> notOffered
      Raw _ _ -> notOffered

-- | The reason for refusing a profile: @impossible-profile@ if it describes no array;
-- @not-factored@ if that cannot be decided because q^n - 1 is not factored.
unopened :: ProfileError -> String
unopened why = case why of
  ProfilePolynomial (OrderNotFactored _) -> "not-factored"
  _ -> "impossible-profile"
