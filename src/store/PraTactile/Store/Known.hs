{-# LANGUAGE CPP #-}
{-# OPTIONS_GHC -O0 #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Which kind of database a name means. Nothing of this module is inlined elsewhere, so that the
-- static program, which has no PostgreSQL, is linked with another one in its place
-- (@tools/static.sh@).
module PraTactile.Store.Known
  ( backendOf,
  )
where

import PraTactile.Store.Address
import PraTactile.Store.Backend (Backend)
import PraTactile.Store.Error (StoreError (..))
#ifdef POSTGRESQL
import PraTactile.Store.Postgresql (postgresql)
#endif
import PraTactile.Store.Sqlite (sqlite)

-- | The database of this name: on a server where it is an address, else in a file.
backendOf :: String -> Either StoreError Backend
backendOf name
  | isAddress name = maybe (Left noAddress) onServer (readAddress name)
  | otherwise = Right (sqlite name)
  where
    noAddress = maybe UnreadableAddress UnknownScheme (unknownScheme name)

onServer :: Address -> Either StoreError Backend
#ifdef POSTGRESQL
onServer = Right . postgresql
#else
onServer = Left . WithoutServers . shownAddress
#endif
