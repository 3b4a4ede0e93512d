-- | Writes the plan of the house, its modules and their imports, to standard output in the language
-- of Graphviz. Run it from the top of the repository: @runghc -itest tools/House.hs@.
module Main (main) where

import House.Graph (dot)
import House.Source (readHouse)

main :: IO ()
main = readHouse "." >>= putStr . dot
