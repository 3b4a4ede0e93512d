-- | What the planted functions are made of, under names that no module hides.
module Original
  ( module Prelude,
    unless,
    when,
  )
where

import Control.Monad (unless, when)
